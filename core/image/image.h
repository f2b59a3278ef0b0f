#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "core/base/uninitialized.h"
#include "core/numerics/vec.h"

namespace etalon {

/// Meaning of stored values: light; light encoded by sRGB's curve; or display values of programs
/// without a notion of light, which files of either kind store unchanged.
enum class Encoding { linear, srgb, display };

/// Bytes of pixels, left uninitialized for readers to fill. They are not in large pages: a virtual
/// machine gives free ones back to its host, and each then takes a millisecond or two to get again.
using PixelBytes = std::vector<std::uint8_t, Uninitialized<std::uint8_t>>;

/// Pixels in rows from the top, with interleaved channels (R, G, B, ...). Eight-bit sources are
/// stored as bytes, since a skybox is six large images.
struct Image {
    int width = 0, height = 0, channels = 0;
    std::variant<PixelBytes, std::vector<float>> pixels;
    Encoding encoding = Encoding::linear;
    std::optional<Imath::V2i> origin;  ///< of the upper left pixel in its frame, if the file has it
    std::optional<Imath::Box2i> frame{};  ///< inclusive on both ends, if the file has it

    bool empty() const { return width == 0; }

    /// Returns the first three channels as stored: bytes divided by 255, floats unchanged. An image
    /// of one channel, or one with alpha, is grey. 0 <= x < width, 0 <= y < height.
    Color color(int x, int y) const;

    /// Calls use(color), where color(x, y) gives the same as the member. This is for several
    /// pixels, as the type of the stored values is tested once.
    template <class Use>
    void with_colors(const Use& use) const;

    /// Returns the first three channels converted by `convert`, which takes a stored value, a byte
    /// or a float, to a number.
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
void Image::with_colors(const Use& use) const {
    const auto place = [&](int x, int y) {
        return (static_cast<std::size_t>(y) * width + x) * channels;
    };
    return std::visit(
        [&](const auto& values) {
            if (channels < 3) {
                use([&](int x, int y) { return Color(detail::as_stored(values[place(x, y)])); });
            } else {
                use([&](int x, int y) {
                    const auto* p = &values[place(x, y)];
                    return Color(detail::as_stored(p[0]), detail::as_stored(p[1]),
                                 detail::as_stored(p[2]));
                });
            }
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

/// Return the colours of all pixels, in rows from the top: as light, or as display values. sRGB's
/// curve converts between them; values stored as sRGB may be either.
std::vector<Color> linear_pixels(const Image& image);
std::vector<Color> display_pixels(const Image& image);

/// Returns the light of the 256 bytes that sRGB's curve encodes.
const std::array<float, 256>& decoded_byte_values();

/// Converts display values to the light for which they stand, by sRGB's curve, which is continued
/// above 1 and is linear below 0.
void decode(std::vector<Color>& display_values);

/// Returns the part of `pixels`, in rows of `width`, that lies in a window, inclusive on both ends.
std::vector<Color> cut_out(const std::vector<Color>& pixels, int width, const Imath::Box2i& window);

}  // namespace etalon
