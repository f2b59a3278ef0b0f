// NFF, Eric Haines' Neutral File Format (1987), as the Standard Procedural Databases write it.
#pragma once

#include "core/formats/load.h"

namespace etalon {

LoadResult load_nff(std::string_view text, const std::string& path, const LoadOptions& options);

}  // namespace etalon
