#pragma once

#include <string>

#include "core/formats/load.h"

namespace etalon {

/// Returns a difference between two scenes or their settings that changes the image, to the last
/// bit; empty if there is none. Arrays may be ordered differently, and planes may have normals of
/// other lengths, by powers of two. Both results must have scenes.
std::string difference(const LoadResult& a, const LoadResult& b);

}  // namespace etalon
