// Images by formulas that another program can evaluate too: linear RGB by rows from the top. They
// use only +, -, * and integers, so that every machine and language gives the same floats.
#pragma once

#include <vector>

#include "core/numerics/vec.h"

namespace etalon::test {

/// Calls color(x, y) for each pixel.
template <class Formula>
std::vector<Color> image_of(int width, int height, const Formula& color) {
    std::vector<Color> pixels;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) pixels.push_back(color(x, y));
    }
    return pixels;
}

/// Returns 0 to 255/256 in steps.
inline float level(int n) {
    return static_cast<float>(n & 255) / 256.0F;
}

/// Returns slanted ramps of three widths.
inline std::vector<Color> stripes(int width, int height) {
    return image_of(width, height, [](int x, int y) {
        return Color(level(5 * x + y), level(3 * x - 2 * y), level(x + 7 * y));
    });
}

/// Returns circles that become denser from the upper left on.
inline std::vector<Color> rings(int width, int height) {
    return image_of(width, height, [](int x, int y) {
        const int r = x * x + y * y;
        return Color(level(r / 16), level(r / 24), level(r / 40));
    });
}

/// Returns the stripes with every value times `gain` plus `offset`.
inline std::vector<Color> changed(int width, int height, float gain, float offset) {
    std::vector<Color> pixels = stripes(width, height);
    for (Color& c : pixels) c = c * gain + Color(offset);
    return pixels;
}

inline std::vector<Color> faded(int width, int height) {
    return changed(width, height, 0.875F, 0.03125F);
}

/// Returns values beyond black and white.
inline std::vector<Color> bright(int width, int height) {
    return changed(width, height, 3, -0.5F);
}

}  // namespace etalon::test
