#pragma once

#include <cstring>

#include "core/image/rendered_image.h"
#include "core/numerics/random.h"

namespace etalon::test {

/// Returns random bit patterns of floats, including infinities, NaNs and denormals, in a window of
/// a frame.
inline RenderedImage random_image(int width, int height, const Imath::Box2i& window) {
    RenderedImage image{width, height, window, {}, false, {}};
    const Imath::V2i size = window.size() + Imath::V2i(1);
    Random random(12345);
    for (int i = 0; i < size.x * size.y; ++i) {
        Color c;
        for (int k = 0; k < 3; ++k) {
            const auto bits = static_cast<std::uint32_t>(random.bits());
            std::memcpy(&c[k], &bits, sizeof bits);
        }
        image.pixels.push_back(c);
    }
    return image;
}

inline RenderedImage random_image(int width, int height) {
    return random_image(width, height, {{0, 0}, {width - 1, height - 1}});
}

}  // namespace etalon::test
