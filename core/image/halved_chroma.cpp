#include "core/image/halved_chroma.h"

#include <algorithm>

namespace etalon {

Color HalvedChroma::color(int x, int y) const {
    const int column = x / 2, row = y / 2;
    const int beside = std::clamp(x % 2 == 0 ? column - 1 : column + 1, 0, chroma_width() - 1);
    const int beyond = std::clamp(y % 2 == 0 ? row - 1 : row + 1, 0, chroma_height() - 1);
    const auto chroma = [&](const std::uint8_t* near, const std::uint8_t* far) {
        const int here = 3 * near[column] + far[column], there = 3 * near[beside] + far[beside];
        return ((3 * here + there + (x % 2 == 0 ? 8 : 7)) >> 4) - 128;
    };
    const int cb = chroma(blue(row), blue(beyond)), cr = chroma(red(row), red(beyond));

    using F = ChromaFactors;
    const int brightness = luma(y)[x];
    const auto channel = [&](int difference) {
        const int byte = brightness + ((difference + F::half) >> F::bits);
        return detail::as_stored(static_cast<std::uint8_t>(std::clamp(byte, 0, 255)));
    };
    return {channel(F::red_of_red * cr), channel(F::green_of_blue * cb + F::green_of_red * cr),
            channel(F::blue_of_blue * cb)};
}

}  // namespace etalon
