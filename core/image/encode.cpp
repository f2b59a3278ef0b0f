#include "core/image/encode.h"

#include "core/color/srgb.h"
#include "core/image/srgb_bytes.h"
#include "core/parallel/parallel.h"

namespace etalon {

std::uint8_t srgb_byte(float value, double gain) {
    static const SrgbBytes bytes;
    return bytes(displayed(gain * value));
}

std::uint8_t display_byte(float value, double gain) {
    const double shown = gain == 1 ? value : srgb_encoded(gain * srgb_decoded(value));
    return static_cast<std::uint8_t>(255.99 * displayed(shown));
}

namespace {

template <class Encode>
std::vector<std::uint8_t> encoded(const std::vector<Color>& pixels, const Encode& encode) {
    std::vector<std::uint8_t> bytes(3 * pixels.size());
    const float* const values = reinterpret_cast<const float*>(pixels.data());
    parallel_for(bytes.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
        std::uint8_t* const to = bytes.data();
        for (std::size_t i = begin; i < end; ++i) to[i] = encode(values[i]);
    });
    return bytes;
}

}  // namespace

std::vector<std::uint8_t> display_bytes(const RenderedImage& image, double exposure) {
    const double gain = std::exp2(exposure);
    return image.display_colors
               ? encoded(image.pixels, [&](float value) { return display_byte(value, gain); })
               : encoded(image.pixels, [&](float value) { return srgb_byte(value, gain); });
}

}  // namespace etalon
