#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "core/numerics/vec.h"
#include "core/parallel/large_pages.h"

namespace etalon {

/// Meaning of stored values: light; or light encoded by sRGB's curve; or display values of programs
/// that know no light, which files of either kind hold as they are.
enum class Encoding { linear, srgb, display };

/// Bytes of pixels, which readers fill.
using PixelBytes = std::vector<std::uint8_t, UninitializedLargePages<std::uint8_t>>;

/// Pixels by rows from the top, channels interleaved (R, G, B, ...). Eight-bit sources stay bytes:
/// a skybox is six large images.
struct Image {
    int width = 0, height = 0, channels = 0;
    std::variant<PixelBytes, std::vector<float>> pixels;
    Encoding encoding = Encoding::linear;
    std::optional<Imath::V2i> origin;  ///< of the upper left pixel in its frame, where files say it
    std::optional<Imath::V2i> frame{};  ///< size of the frame, where files say it

    bool empty() const { return width == 0; }

    /// The first three channels as stored: bytes divided by 255, floats as they are. One channel,
    /// or one with alpha, is grey. 0 <= x < width, 0 <= y < height.
    Color color(int x, int y) const;

    /// Calls use(color), where color(x, y) is what color() gives: for several at a time, as what
    /// the image stores is looked at once.
    template <class Use>
    Color with_colors(const Use& use) const;

    /// The first three channels by `convert`, which takes what is stored, a byte or a float, to a
    /// number.
    template <class Convert>
    Color converted(int x, int y, const Convert& convert) const;
};

namespace detail {

inline constexpr auto byte_values = [] {
    std::array<float, 256> values{};
    for (int i = 0; i < 256; ++i) values[i] = static_cast<float>(i) / 255.0F;
    return values;
}();

inline float as_stored(std::uint8_t value) {
    return byte_values[value];
}
inline float as_stored(float value) {
    return value;
}

}  // namespace detail

template <class Use>
Color Image::with_colors(const Use& use) const {
    const auto place = [&](int x, int y) {
        return (static_cast<std::size_t>(y) * width + x) * channels;
    };
    return std::visit(
        [&](const auto& values) {
            if (channels < 3) {
                return use(
                    [&](int x, int y) { return Color(detail::as_stored(values[place(x, y)])); });
            }
            return use([&](int x, int y) {
                const auto* p = &values[place(x, y)];
                return Color(detail::as_stored(p[0]), detail::as_stored(p[1]),
                             detail::as_stored(p[2]));
            });
        },
        pixels);
}

template <class Convert>
Color Image::converted(int x, int y, const Convert& convert) const {
    const std::size_t first = (static_cast<std::size_t>(y) * width + x) * channels;
    return std::visit(
        [&](const auto& values) {
            const auto* p = &values[first];
            return channels < 3 ? Color(convert(p[0]))
                                : Color(convert(p[0]), convert(p[1]), convert(p[2]));
        },
        pixels);
}

inline Color Image::color(int x, int y) const {
    return converted(x, y, [](auto value) { return detail::as_stored(value); });
}

/// The colours of all pixels, by rows from the top: as light, or as display values. sRGB's curve
/// leads from one to the other; what is stored as sRGB may be either.
std::vector<Color> linear_pixels(const Image& image);
std::vector<Color> display_pixels(const Image& image);

/// The light of the 256 bytes that sRGB's curve encodes.
const std::array<float, 256>& decoded_byte_values();

/// The light that display values stand for: sRGB's curve, continued above 1. Below it is a line.
void decode(std::vector<Color>& display_values);

/// The part of `pixels`, of rows `width` long, that lies in a window, inclusive on both ends.
std::vector<Color> cut_out(const std::vector<Color>& pixels, int width, const Imath::Box2i& window);

}  // namespace etalon
