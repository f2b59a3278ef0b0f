#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/numerics/vec.h"
#include "core/sampling/point_names.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// A decision at a vertex of a path. Each takes a place in [0, 1)^2 and up to two choices in [0,
/// 1).
enum class Decision : std::uint32_t {
    light,      ///< the first choice selects a light, the place a point on it
    direction,  ///< the choices select a lobe and survival, the place a direction of the lobe
    flight,     ///< the place selects a distance in a medium, and a point of the ray to connect
    probe,      ///< where subsurface light enters
};

/// The points for one kind of decision at many vertices, generated together. Those of the samples
/// of a pixel at vertices of one name form well distributed sets, one of places and one of choices.
class VertexPoints {
  public:
    explicit VertexPoints(Decision decision) : decision_(decision) {}

    void clear() { names_.clear(); }

    /// Adds sample number `index` of the vertices that `seed` identifies.
    void add(std::uint32_t seed, std::uint32_t index) { names_.add(seed, index); }

    /// Generates the points of all vertices that were added since clear().
    void make(Sampler sampler);

    /// Returns the place, or the choices, of the i-th vertex that was added.
    const Vec2& place(std::size_t i) const { return points_[0][i]; }
    const Vec2& choices(std::size_t i) const { return points_[1][i]; }

  private:
    Decision decision_;
    PointNames names_;
    std::array<std::vector<Vec2>, 2> points_;
};

}  // namespace etalon
