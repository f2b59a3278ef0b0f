#include "core/image/image.h"

#include <array>

#include "core/image/srgb.h"

namespace etalon {
namespace {

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

}  // namespace

std::vector<Color> linear_pixels(const Image& image) {
    const bool encoded = image.encoding == Encoding::srgb;
    std::vector<Color> pixels;
    pixels.reserve(static_cast<std::size_t>(image.width) * image.height);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto linear = [](auto value) { return decoded(value); };
            pixels.push_back(encoded ? image.converted(x, y, linear) : image.color(x, y));
        }
    }
    return pixels;
}

}  // namespace etalon
