#include "core/image/image.h"

#include <array>

#include "core/color/decode_srgb.h"
#include "core/color/srgb.h"
#include "core/parallel/parallel.h"

namespace etalon {
namespace {

float decoded(float value) {
    return static_cast<float>(srgb_decoded(value));
}
float decoded(std::uint8_t value) {
    return decoded_byte_values()[value];
}

template <class Convert>
std::vector<Color> converted_pixels(const Image& image, const Convert& convert) {
    const auto width = static_cast<std::size_t>(image.width);
    std::vector<Color> pixels(width * image.height);
    parallel_for(static_cast<std::size_t>(image.height), 16,
                 [&](std::size_t begin, std::size_t end) {
                     for (std::size_t y = begin; y < end; ++y) {
                         for (std::size_t x = 0; x < width; ++x) {
                             pixels[y * width + x] =
                                 image.converted(static_cast<int>(x), static_cast<int>(y), convert);
                         }
                     }
                 });
    return pixels;
}

constexpr auto as_it_is = [](auto value) { return detail::as_stored(value); };

}  // namespace

const std::array<float, 256>& decoded_byte_values() {
    static const auto table = [] {
        std::array<float, 256> entries{};
        for (int i = 0; i < 256; ++i) entries[i] = static_cast<float>(srgb_decoded(i / 255.0));
        return entries;
    }();
    return table;
}

std::vector<Color> linear_pixels(const Image& image) {
    if (image.encoding == Encoding::linear) return converted_pixels(image, as_it_is);
    return converted_pixels(image, [](auto value) { return decoded(value); });
}

std::vector<Color> display_pixels(const Image& image) {
    if (image.encoding != Encoding::linear) return converted_pixels(image, as_it_is);
    return converted_pixels(image, [](auto value) {
        return static_cast<float>(srgb_encoded(detail::as_stored(value)));
    });
}

void decode(std::vector<Color>& display_values) {
    parallel_for(display_values.size(), 1024, [&](std::size_t begin, std::size_t end) {
        decode_srgb({&display_values[begin].x, 3 * (end - begin)});
    });
}

std::vector<Color> cut_out(const std::vector<Color>& pixels, int width,
                           const Imath::Box2i& window) {
    std::vector<Color> part;
    for (int y = window.min.y; y <= window.max.y; ++y) {
        const auto row = pixels.begin() + static_cast<std::ptrdiff_t>(y) * width;
        part.insert(part.end(), row + window.min.x, row + window.max.x + 1);
    }
    return part;
}

}  // namespace etalon
