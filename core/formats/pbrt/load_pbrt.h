#pragma once

#include "core/formats/load.h"

namespace etalon {

/// Reads a scene in the format of PBRT version 3: one of its frames.
LoadResult load_pbrt(std::string_view text, const std::string& path, const LoadOptions& options);

}  // namespace etalon
