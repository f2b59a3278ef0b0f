#pragma once

#include <vector>

#include "core/scene/geometry.h"

namespace etalon {

/// Finds the vertices that smooth triangles share: same position, same normal, to the bit.
class SmoothVertices {
  public:
    /// Number of the vertex, which is added to the geometry if it is new.
    std::uint32_t number(Geometry& geometry, const Vec3& position, const Vec3& normal);

  private:
    void grow(const Geometry& geometry);
    std::size_t place_of(const Geometry& geometry, const Vec3& position, const Vec3& normal) const;

    std::vector<std::uint32_t> table_;  ///< hash table of 2^k places, half of them empty at least
    std::size_t size_ = 0;
    std::uint32_t normal_offset_ = 0;  ///< offset of all vertices in the table
};

}  // namespace etalon
