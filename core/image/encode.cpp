#include "core/image/encode.h"

#include "core/color/srgb.h"

namespace etalon {

namespace {

std::uint8_t byte_of_light(float value, double gain) {
    return static_cast<std::uint8_t>(255 * srgb_encoded(displayed(gain * value)) + 0.5);
}

std::uint8_t byte_of_display(float value, double gain) {
    return static_cast<std::uint8_t>(255.99 * displayed(gain * value));
}

template <class Encode>
std::vector<std::uint8_t> encoded(const std::vector<Color>& pixels, const Encode& encode) {
    std::vector<std::uint8_t> bytes(3 * pixels.size());
    std::uint8_t* to = bytes.data();
    for (const Color& c : pixels) {
        for (const float value : {c.x, c.y, c.z}) *to++ = encode(value);
    }
    return bytes;
}

}  // namespace

std::uint8_t srgb_byte(float value, double gain) {
    return byte_of_light(value, gain);
}

std::uint8_t display_byte(float value, double gain) {
    return byte_of_display(value, gain);
}

std::vector<std::uint8_t> display_bytes(const RenderedImage& image, double exposure) {
    const double gain = std::exp2(exposure);
    return image.display_colors
               ? encoded(image.pixels, [&](float value) { return byte_of_display(value, gain); })
               : encoded(image.pixels, [&](float value) { return byte_of_light(value, gain); });
}

}  // namespace etalon
