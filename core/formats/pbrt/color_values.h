#pragma once

#include <span>
#include <vector>

#include "core/formats/pbrt/declared_type.h"

namespace etalon::pbrt {

/// Converts the numbers of a colour parameter to r g b, one triple for each value. Their count must
/// be a multiple of what the type requires.
std::vector<float> to_rgb(const DeclaredType& type, std::vector<float> numbers);

}  // namespace etalon::pbrt
