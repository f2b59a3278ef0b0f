// Comparison of frames, ignoring numbers of transforms and area lights, which depend on order, and
// names of objects and media.
#pragma once

#include <string>

#include "core/formats/pbrt/frame.h"

namespace etalon::pbrt {

/// Returns what is different; empty if nothing is.
std::string difference(const Frame& a, const Frame& b);

}  // namespace etalon::pbrt
