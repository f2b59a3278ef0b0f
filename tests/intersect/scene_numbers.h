// The numbers of a scene of one shape.
#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace etalon {

/// Returns the scene with every length multiplied by 2^k.
Scene scaled(Scene scene, int k);

/// Returns every double that defines the scene's only shape.
std::vector<double*> numbers_of(Scene& scene);

/// Recomputes the data that the shape derives from its numbers, after these have been changed.
void finalize(Scene& scene);

}  // namespace etalon
