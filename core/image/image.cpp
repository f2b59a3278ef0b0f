#include "core/image/image.h"

namespace etalon {
namespace {

float number(std::uint8_t stored) {
    return static_cast<float>(stored) / 255.0F;
}
float number(float stored) {
    return stored;
}

}  // namespace

Color Image::color(int x, int y) const {
    const std::size_t first = (static_cast<std::size_t>(y) * width + x) * channels;
    return std::visit(
        [&](const auto& values) {
            const auto* p = &values[first];
            return channels < 3 ? Color(number(p[0]))
                                : Color(number(p[0]), number(p[1]), number(p[2]));
        },
        pixels);
}

}  // namespace etalon
