#pragma once

#include <span>
#include <vector>

#include "core/formats/pbrt/declared_type.h"

namespace etalon::pbrt {

/// Converts the numbers of a parameter that declares a colour to r g b, one triple a value. Their
/// count is a multiple of what the type says.
std::vector<float> to_rgb(const DeclaredType& type, std::vector<float> numbers);

}  // namespace etalon::pbrt
