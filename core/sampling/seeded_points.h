#pragma once

#include <span>
#include <vector>

#include "core/numerics/vec.h"
#include "core/sampling/vertex_names.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// Single points of many point sets, generated together: see PointSet, which gives the same points.
class SeededPoints {
  public:
    void clear() { names_.clear(); }

    /// Adds point number `index` of the set with that seed.
    void add(std::uint32_t seed, std::uint32_t index) { names_.add(seed, index); }

    /// Replaces the points by number `k` of `parts` of a choice at each vertex.
    void name(const VertexNames& vertices, std::uint32_t choice, std::uint32_t k,
              std::uint32_t parts) {
        vertices.name_points(choice, k, parts, names_);
    }

    /// Returns the points, in the order in which they were added since clear() or of the vertices.
    /// They are valid until the next call, and padded for vector instructions.
    std::span<const Vec2> make(Sampler sampler);

  private:
    PointNames names_;
    std::vector<Vec2> points_;
};

}  // namespace etalon
