#pragma once

#include <cstdint>
#include <vector>

namespace etalon {

/// How a surface scatters light that is the same turned about its normal: for pairs of angles to
/// the normal, the BSDF times the cosine of light's direction as a Fourier series in the angle
/// between the two about the normal. Between the pairs it is a spline (Jakob, d'Eon, Jakob &
/// Marschner 2014, "A Comprehensive Framework for Rendering Layered Materials").
struct FourierTable {
    /// The coefficients of one pair, of one channel after the other.
    struct Series {
        std::uint32_t first, length;  ///< the length is that of one channel
    };

    float eta = 1;     ///< index below the surface over that above
    int channels = 1;  ///< 1, or 3 for luminance, red and blue
    /// Cosines of the directions to the normal, increasing. Light's direction is the one in which
    /// it goes.
    std::vector<float> cosines;
    std::vector<float> sums;  ///< integrals over light's cosine of the first coefficient, up to it
    std::vector<Series> series;  ///< likewise of pair (o, i) of cosines, at o * cosines.size() + i
    std::vector<float> coefficients;
};

}  // namespace etalon
