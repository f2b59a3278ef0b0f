#include "core/image/metrics/flip.h"

#include "core/color/srgb.h"
#include "core/image/metrics/flip_colors.h"
#include "core/image/metrics/flip_parts.h"
#include "core/image/metrics/fold.h"

namespace etalon {
namespace {

YCxCz ycxcz_planes(Pixels image, int width) {
    const int height = static_cast<int>(image.size()) / width;
    YCxCz planes = {PixelPlane(width, height), PixelPlane(width, height),
                    PixelPlane(width, height)};
    for_each_row(height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const Color& c = image[static_cast<std::size_t>(y) * width + x];
            const Vec3 color = ycxcz_of_linear({displayed(c.x), displayed(c.y), displayed(c.z)});
            for (int k = 0; k < 3; ++k) planes[k].row(y)[x] = color[k];
        }
    });
    return planes;
}

struct Seen {
    std::vector<Vec3> colors;
    Features features;
};

Seen look_at(Pixels image, int width) {
    const YCxCz planes = ycxcz_planes(image, width);
    return {seen_colors(planes), find_features(planes[0])};
}

}  // namespace

PixelPlane flip_map(Pixels a, Pixels b, int width) {
    const Seen first = look_at(a, width), second = look_at(b, width);
    return plane_of(width, static_cast<int>(a.size()) / width, [&](std::size_t i) {
        // Section 4.3: a difference of features amplifies a difference of colours.
        return std::pow(color_difference(first.colors[i], second.colors[i]),
                        1 - feature_difference(first.features, second.features, i));
    });
}

double flip(const PixelPlane& map) {
    return sum<double>(map.values.size(), [&](std::size_t i) { return map.values[i]; }) /
           static_cast<double>(map.values.size());
}

}  // namespace etalon
