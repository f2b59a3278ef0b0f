// Interpolation of images at many points, each between the centres of four pixels.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/image/image.h"
#include "core/image/subsampled_image.h"

namespace etalon {

/// Points of an image: a pixel, in whose centre x and y are 0, and distances to it in pixels.
struct BilinearPoints {
    static constexpr std::size_t most = 64;

    bool is_full() const { return count == most; }

    /// Adds the point at a part of the width and of the height, from the upper left, both in
    /// [0, 1]. Beyond the outermost centres it is on the edge of these.
    void add(int width, int height, double s, double t) {
        const double px = std::clamp(s * width - 0.5, 0.0, width - 1.0);
        const double py = std::clamp(t * height - 0.5, 0.0, height - 1.0);
        x[count] = static_cast<std::int32_t>(px);
        y[count] = static_cast<std::int32_t>(py);
        fx[count] = static_cast<float>(px - x[count]);
        fy[count] = static_cast<float>(py - y[count]);
        ++count;
    }

    std::size_t count = 0;
    alignas(64) std::array<std::int32_t, most> x, y;
    alignas(64) std::array<float, most> fx, fy;
};

using BilinearColors = std::array<Color, BilinearPoints::most>;

/// Interpolate the colours of four pixels each, as they are stored. The colours from `count` on are
/// undefined.
void interpolate(const Image& image, const BilinearPoints& points, BilinearColors& colors);
void interpolate(const SubsampledImage& image, const BilinearPoints& points,
                 BilinearColors& colors);

}  // namespace etalon
