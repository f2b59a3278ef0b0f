#pragma once

#include <array>
#include <cstdint>

namespace etalon {

/// Red, green, blue, as sRGB shows them: from black at 0 by violet and orange to a pale yellow at
/// 1, ever brighter. What is outside of [0, 1] is taken to its nearer end.
std::array<std::uint8_t, 3> magma(double value);

}  // namespace etalon
