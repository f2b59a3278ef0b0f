#pragma once

#include <string>

#include "core/scene/scene.h"

namespace etalon {

/// What no file may bring about: an index out of bounds, a number that is not finite, a radius or
/// an extent below zero. Empty where all is well.
std::string insanity(const Scene& scene);

}  // namespace etalon
