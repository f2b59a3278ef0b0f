// The curve of sRGB, IEC 61966-2-1.
#pragma once

#include <algorithm>
#include <cmath>

namespace etalon {

/// Returns a linear value as displayed: in [0, 1], with NaN as black (the comparison is false).
inline double displayed(double linear) {
    return linear > 0 ? std::min(linear, 1.0) : 0.0;
}

/// Encodes a linear value by sRGB's curve, [0, 1] to [0, 1].
inline double srgb_encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// Decodes a value: the inverse of srgb_encoded().
inline double srgb_decoded(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// Returns the slope of srgb_decoded() at a value that it decodes to `linear`.
inline double srgb_slope(double encoded, double linear) {
    return encoded <= 0.04045 ? 1 / 12.92 : 2.4 * linear / (encoded + 0.055);
}

}  // namespace etalon
