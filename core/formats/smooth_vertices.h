#pragma once

#include <vector>

#include "core/scene/geometry.h"

namespace etalon {

/// Finds the vertices that smooth triangles share: those of the same position and normal, bit for
/// bit.
class SmoothVertices {
  public:
    /// Returns the number of the vertex, which is added to the geometry if it is new.
    std::uint32_t number(Geometry& geometry, const Vec3& position, const Vec3& normal);

  private:
    struct Entry {
        std::uint32_t hash = 0, vertex = no_index;
    };

    void grow();

    /// Returns the place at which the search for a vertex with this hash begins.
    std::size_t first_place(std::uint32_t hash) const { return hash & (table_.size() - 1); }
    std::size_t next_place(std::size_t place) const { return (place + 1) & (table_.size() - 1); }

    std::vector<Entry> table_;  ///< of 2^k places, at least half of them empty
    std::size_t size_ = 0;
    std::uint32_t normal_offset_ = 0;  ///< offset of all vertices in the table
};

}  // namespace etalon
