// SCE, the scene format of a ray tracing course (EECS 487, University of Michigan): a line, a
// command, as the OpenGL of its time drew.
#pragma once

#include "core/formats/load.h"

namespace etalon {

LoadResult load_sce(std::string_view text, const std::string& path, const LoadOptions& options);

}  // namespace etalon
