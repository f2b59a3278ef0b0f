#pragma once

#include "core/formats/load.h"

namespace etalon {

/// Reads one frame of a scene in the format of PBRT version 3.
LoadResult load_pbrt(std::string_view text, const std::string& path, const LoadOptions& options);

}  // namespace etalon
