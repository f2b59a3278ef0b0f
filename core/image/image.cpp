#include "core/image/image.h"

#include <array>

#include "core/image/srgb.h"

namespace etalon {
namespace {

float as_stored(std::uint8_t value) {
    return static_cast<float>(value) / 255.0F;
}
float as_stored(float value) {
    return value;
}

float decoded(float value) {
    return static_cast<float>(srgb_decoded(value));
}
float decoded(std::uint8_t value) {
    static const auto table = [] {
        std::array<float, 256> entries{};
        for (int i = 0; i < 256; ++i) entries[i] = static_cast<float>(srgb_decoded(i / 255.0));
        return entries;
    }();
    return table[value];
}

/// Colour of a pixel; `convert` takes what is stored, a byte or a float, to a number.
template <class Convert>
Color color_at(const Image& image, int x, int y, const Convert& convert) {
    const std::size_t first = (static_cast<std::size_t>(y) * image.width + x) * image.channels;
    return std::visit(
        [&](const auto& values) {
            const auto* p = &values[first];
            return image.channels < 3 ? Color(convert(p[0]))
                                      : Color(convert(p[0]), convert(p[1]), convert(p[2]));
        },
        image.pixels);
}

}  // namespace

Color Image::color(int x, int y) const {
    return color_at(*this, x, y, [](auto value) { return as_stored(value); });
}

std::vector<Color> linear_pixels(const Image& image) {
    const bool encoded = image.encoding == Encoding::srgb;
    std::vector<Color> pixels;
    pixels.reserve(static_cast<std::size_t>(image.width) * image.height);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto linear = [](auto value) { return decoded(value); };
            pixels.push_back(encoded ? color_at(image, x, y, linear) : image.color(x, y));
        }
    }
    return pixels;
}

}  // namespace etalon
