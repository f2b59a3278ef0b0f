// Spectra as colours: linear RGB with the primaries of sRGB and Rec. 709.
#pragma once

#include <span>

#include "core/numerics/vec.h"

namespace etalon {

struct SpectralSample {
    double wavelength;  ///< in nm
    double value;
};

/// Returns the colour of CIE coordinates X, Y and Z. It may have negative parts.
Color xyz_color(const Vec3& xyz);

/// Returns the colour of a spectrum that is linear between its samples, which may be in any order,
/// and constant beyond them; black if there is none. Of several samples at one wavelength the first
/// applies to smaller wavelengths and the last to larger ones.
///
/// X, Y and Z are sums over the wavelengths of cie_1931(), with no illuminant, so that a spectrum
/// of ones is not white: (1.20, 0.95, 0.91). The factor is that of PBRT v3, whose scenes are made
/// for it.
Color spectrum_color(std::span<const SpectralSample> samples);

/// Returns the colour of a black body, with its spectrum scaled to a maximum of 1 at any
/// wavelength; black at 0 kelvin and below.
Color blackbody_color(double kelvin);

}  // namespace etalon
