// P3F, the scene format of a ray tracing course (P3D, IST Lisbon), in its old dialect (v, f, l) and
// its new one (camera, mat, light), freely mixed.
#pragma once

#include "core/formats/load.h"

namespace etalon {

LoadResult load_p3f(std::string_view text, const std::string& path, const LoadOptions& options);

}  // namespace etalon
