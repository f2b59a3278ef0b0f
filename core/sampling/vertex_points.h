#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/numerics/vec.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// What a vertex of a path decides by a place and up to two choices, all in [0, 1).
enum class Decision : std::uint32_t {
    light,   ///< a light by the first choice, and the place on it
    way,     ///< a lobe and survival by the choices, and the place among the lobe's directions
    flight,  ///< how far a ray goes in a medium, by the place, and where on it a light is asked
    probe,   ///< where light comes in that is scattered below a surface
};

/// The points by which vertices take one of their decisions, made together. Those of the samples of
/// a pixel at vertices of one name make well distributed sets, one of places and one of choices.
class VertexPoints {
  public:
    explicit VertexPoints(Decision decision) : decision_(decision) {}

    void clear();

    /// Adds sample number `index` of the vertices that `seed` names.
    void add(std::uint32_t seed, std::uint32_t index);

    /// Makes all that were added since clear().
    void make(Sampler sampler);

    /// The place and the choices of the i-th that was added.
    const Vec2& place(std::size_t i) const { return points_[0][i]; }
    const Vec2& choices(std::size_t i) const { return points_[1][i]; }

  private:
    Decision decision_;
    std::size_t size_ = 0;
    std::vector<std::uint32_t> seeds_, indices_;
    std::array<std::vector<Vec2>, 2> points_;
};

}  // namespace etalon
