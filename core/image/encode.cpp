#include "core/image/encode.h"

#include <algorithm>
#include <cmath>

namespace etalon {
namespace {

/// gain * value in [0, 1]. The comparison is false for NaN.
double clamped(float value, double gain) {
    const double scaled = gain * static_cast<double>(value);
    return scaled > 0 ? std::min(scaled, 1.0) : 0.0;
}

double srgb_curve(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

}  // namespace

std::uint8_t srgb_byte(float value, double gain) {
    return static_cast<std::uint8_t>(255 * srgb_curve(clamped(value, gain)) + 0.5);
}

std::uint8_t display_byte(float value, double gain) {
    return static_cast<std::uint8_t>(255.99 * clamped(value, gain));
}

std::vector<std::uint8_t> display_bytes(const Picture& picture, double exposure) {
    const auto encode = picture.display_colors ? display_byte : srgb_byte;
    const double gain = std::exp2(exposure);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * picture.pixels.size());
    for (const Color& c : picture.pixels) {
        for (const float value : {c.x, c.y, c.z}) bytes.push_back(encode(value, gain));
    }
    return bytes;
}

}  // namespace etalon
