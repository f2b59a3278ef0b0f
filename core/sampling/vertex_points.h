#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/numerics/vec.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// What decides at a vertex of a path; all in [0, 1).
struct VertexPoint {
    Vec2 on_light;    ///< point of the light that is asked
    Vec2 direction;   ///< of the lobe that scatters
    double light;     ///< which light is asked
    double lobe;      ///< which lobe scatters
    double survival;  ///< whether the path goes on
};

/// The choices at vertices, made together. Those of the samples of a pixel at vertices of one name
/// make well distributed sets, one for each pair of choices.
class VertexPoints {
  public:
    void clear();

    /// Adds sample number `index` of the vertices that `seed` names.
    void add(std::uint32_t seed, std::uint32_t index);

    /// Makes all that were added since clear().
    void make(Sampler sampler);

    /// The choices of the i-th that was added.
    VertexPoint operator[](std::size_t i) const {
        const auto& [on_light, direction, choices, survival] = points_;
        return {on_light[i], direction[i], choices[i].x, choices[i].y, survival[i].x};
    }

    /// Number of two-dimensional sets.
    static constexpr std::size_t sets = 4;

  private:
    std::size_t size_ = 0;
    std::vector<std::uint32_t> seeds_, indices_;
    std::array<std::vector<Vec2>, sets> points_;
};

}  // namespace etalon
