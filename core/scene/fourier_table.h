#pragma once

#include <cstdint>
#include <vector>

namespace etalon {

/// Tabulated isotropic BSDF. For pairs of angles to the normal it has the BSDF times the cosine of
/// light's direction, as a Fourier series in the azimuth between the two directions. Between the
/// pairs it is a spline (Jakob, d'Eon, Jakob & Marschner 2014, "A Comprehensive Framework for
/// Rendering Layered Materials").
struct FourierTable {
    /// Coefficients of one pair of angles, channel by channel.
    struct Series {
        std::uint32_t first, length;  ///< `length` is that of one channel
    };

    float eta = 1;     ///< index below the surface over that above
    int channels = 1;  ///< 1, or 3 for luminance, red and blue
    /// Cosines of the directions to the normal, increasing. Light's direction is that of its
    /// propagation.
    std::vector<float> cosines;
    std::vector<float> sums;  ///< integrals over light's cosine of the first coefficient, up to it
    std::vector<Series> series;  ///< pair (o, i) of cosines is at o * cosines.size() + i
    std::vector<float> coefficients;
};

}  // namespace etalon
