// Rays as text, the input of `etalon trace`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/intersect/ray.h"

namespace etalon {

/// Numbers of a line. The time is a fraction of the shutter interval. A shadow ray ends with the
/// word.
inline constexpr std::string_view ray_format = "ox oy oz dx dy dz [tmin tmax [time]] [shadow]";

/// Reads a file, or standard input if the path is "-": one ray per line of decimal or hexadecimal
/// floats, with comments from `#` to the end of the line. The error is "FILE:LINE:COLUMN: error:
/// what, and what was expected", or "FILE: error: why it cannot be read".
Result<std::vector<Ray>> read_rays(const std::string& path);

}  // namespace etalon
