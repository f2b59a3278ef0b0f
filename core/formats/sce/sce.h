// SCE, the scene format of a ray tracing course (EECS 487, University of Michigan): one command per
// line, in the style of the OpenGL of its time.
#pragma once

#include "core/formats/load.h"

namespace etalon {

LoadResult load_sce(std::string_view text, const std::string& path, const LoadOptions& options);

}  // namespace etalon
