#pragma once

#include <string>

#include "core/formats/load.h"

namespace etalon {

/// In what two scenes or their settings differ that makes an image differ, to the last bit; empty
/// if in nothing. Arrays may be ordered differently, and planes may have normals of other lengths,
/// by powers of two. Given results with scenes.
std::string difference(const LoadResult& a, const LoadResult& b);

}  // namespace etalon
