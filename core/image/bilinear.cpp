#include "core/image/bilinear.h"

namespace etalon {

void interpolate(const Image& image, const BilinearPoints& points, BilinearColors& colors) {
    image.with_colors([&](const auto& color) {
        for (std::size_t i = 0; i < points.count; ++i) {
            const int x = points.x[i], y = points.y[i];
            const int right = std::min(x + 1, image.width - 1);
            const int below = std::min(y + 1, image.height - 1);
            const float fx = points.fx[i], fy = points.fy[i];
            const Color top = color(x, y) * (1 - fx) + color(right, y) * fx;
            const Color bottom = color(x, below) * (1 - fx) + color(right, below) * fx;
            colors[i] = top * (1 - fy) + bottom * fy;
        }
    });
}

}  // namespace etalon
