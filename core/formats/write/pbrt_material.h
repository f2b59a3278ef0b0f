#pragma once

#include <string>
#include <string_view>

#include "core/formats/write/conversion_warnings.h"
#include "core/scene/material.h"

namespace etalon {

/// The PBRT v3 directives that make a named material as like this one as can be (lines, the last
/// without its end), and what of it is lost.
std::string to_pbrt(const Material& material, std::string_view name, ConversionWarnings& lost);

}  // namespace etalon
