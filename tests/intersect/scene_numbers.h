// A scene of one shape as the numbers that make it up.
#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace etalon {

/// The scene with every length multiplied by 2^k.
Scene scaled(Scene scene, int k);

/// Every double that the scene's only shape is made of.
std::vector<double*> numbers_of(Scene& scene);

/// Works out again what the shape keeps beside its numbers, once these have been changed.
void settle(Scene& scene);

}  // namespace etalon
