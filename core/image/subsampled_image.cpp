#include "core/image/subsampled_image.h"

#include <algorithm>

namespace etalon {

Color SubsampledImage::color(int x, int y) const {
    const int column = x / 2, row = y / 2;
    const int beside = std::clamp(x % 2 == 0 ? column - 1 : column + 1, 0, chroma_width() - 1);
    const int beyond = std::clamp(y % 2 == 0 ? row - 1 : row + 1, 0, chroma_height() - 1);
    const auto chroma = [&](const std::uint8_t* near, const std::uint8_t* far) {
        const int here = 3 * near[column] + far[column], there = 3 * near[beside] + far[beside];
        return ((3 * here + there + (x % 2 == 0 ? 8 : 7)) >> 4) - 128;
    };
    const int blue = chroma(cb(row), cb(beyond)), red = chroma(cr(row), cr(beyond));

    using F = YcbcrFactors;
    const int brightness = luma(y)[x];
    const auto channel = [&](int difference) {
        const int byte = brightness + ((difference + F::half) >> F::bits);
        return detail::as_stored(static_cast<std::uint8_t>(std::clamp(byte, 0, 255)));
    };
    return {channel(F::red_of_cr * red), channel(F::green_of_cb * blue + F::green_of_cr * red),
            channel(F::blue_of_cb * blue)};
}

}  // namespace etalon
