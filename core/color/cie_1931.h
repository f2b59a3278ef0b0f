// The colour matching functions of the CIE 1931 standard colorimetric observer (2 degrees).
#pragma once

#include <array>

#include "core/numerics/vec.h"

namespace etalon {

/// Tabulated wavelengths in nm: 360, 361, ... 830.
inline constexpr int first_wavelength = 360;
inline constexpr int wavelength_count = 471;

/// Values of x-bar, y-bar and z-bar, one triple for each wavelength.
using MatchingFunctions = std::array<Vec3, wavelength_count>;

/// Returns the functions in steps of 1 nm.
const MatchingFunctions& cie_1931();

}  // namespace etalon
