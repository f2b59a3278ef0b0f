#pragma once

#include <string>

#include "core/formats/load.h"

namespace etalon {

/// What no file may bring about: an index out of bounds, a number that is not finite, a radius or
/// an extent below zero. Empty where all is well.
/// Given a result with a scene.
std::string insanity(const LoadResult& result);

}  // namespace etalon
