#include "core/texture/shown_rows.h"

#include "core/color/srgb.h"
#include "core/numerics/luminance.h"

namespace etalon {
namespace {

float decoded(float value) {
    return static_cast<float>(srgb_decoded(value));
}

/// Converts stored values to those of the texture.
struct Decoding {
    bool is_srgb;
    const std::array<float, 256>& bytes = is_srgb ? decoded_byte_values() : detail::byte_values;

    float operator()(std::uint8_t stored) const { return bytes[stored]; }
    float operator()(float stored) const { return is_srgb ? decoded(stored) : stored; }
};

TexelRows channel_rows(const Image& image, int channels, bool decode_srgb) {
    const auto read = [&image, channels, shown = Decoding{decode_srgb}](int y, float* texels) {
        std::visit(
            [&](const auto& stored) {
                const auto* texel =
                    &stored[static_cast<std::size_t>(y) * image.width * image.channels];
                for (int x = 0; x < image.width; ++x, texel += image.channels) {
                    for (int k = 0; k < channels; ++k) *texels++ = shown(texel[k]);
                }
            },
            image.pixels);
    };
    return {image.width, image.height, channels, read};
}

TexelRows luminance_rows(const Image& image, bool decode_srgb) {
    const auto read = [&image, decode_srgb](int y, float* texels) {
        for (int x = 0; x < image.width; ++x) {
            const float value = luminance(image.color(x, y));
            texels[x] = decode_srgb ? decoded(value) : value;
        }
    };
    return {image.width, image.height, 1, read};
}

}  // namespace

TexelRows shown_rows(const Image& image, Shown what, bool decode_srgb) {
    if (image.channels < 3) return channel_rows(image, 1, decode_srgb);
    if (what == Shown::numbers) return luminance_rows(image, decode_srgb);
    return channel_rows(image, 3, decode_srgb);
}

}  // namespace etalon
