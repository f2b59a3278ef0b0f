#include "core/image/encode.h"

#include "core/color/srgb.h"

namespace etalon {

std::uint8_t srgb_byte(float value, double gain) {
    return static_cast<std::uint8_t>(255 * srgb_encoded(displayed(gain * value)) + 0.5);
}

std::uint8_t display_byte(float value, double gain) {
    return static_cast<std::uint8_t>(255.99 * displayed(gain * value));
}

std::vector<std::uint8_t> display_bytes(const RenderedImage& image, double exposure) {
    const auto encode = image.display_colors ? display_byte : srgb_byte;
    const double gain = std::exp2(exposure);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * image.pixels.size());
    for (const Color& c : image.pixels) {
        for (const float value : {c.x, c.y, c.z}) bytes.push_back(encode(value, gain));
    }
    return bytes;
}

}  // namespace etalon
