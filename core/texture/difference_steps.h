#pragma once

#include <vector>

#include "core/texture/texels.h"

namespace etalon {

/// Largest steps by which finite differences of a texture's values show its slopes: a fraction of
/// its finest features. Infinite where it has none.
struct DifferenceSteps {
    double uv = infinity;     ///< in the surface's coordinates
    double space = infinity;  ///< length in world space
};

/// Returns the steps of all textures of numbers. `images` are those of the textures.
std::vector<DifferenceSteps> difference_steps(const Textures& textures,
                                              const std::vector<Texels>& images);

}  // namespace etalon
