#include "core/shading/light_samples.h"

#include <cmath>

namespace etalon {
namespace {

/// Returns the number of columns of the most nearly square grid of exactly `count` points.
int grid_columns(int count) {
    int columns = static_cast<int>(std::sqrt(static_cast<double>(count)));
    while (count % columns != 0) --columns;
    return columns;
}

}  // namespace

LightSamples::LightSamples(const Light& light, int samples_per_pixel) : light_(light) {
    if (const auto* point = std::get_if<PointLight>(&light)) {
        color_ = point->color;
        return;
    }
    const auto& quad = std::get<QuadLight>(light);
    if (samples_per_pixel == 0) {
        count_ = quad.samples;
        columns_ = grid_columns(count_);
    } else {
        is_random_ = true;
        count_ = (quad.samples + samples_per_pixel - 1) / samples_per_pixel;
    }
    color_ = quad.color / static_cast<float>(count_);
}

Vec3 LightSamples::position(int k) const {
    if (const auto* point = std::get_if<PointLight>(&light_)) return point->position;
    const int rows = count_ / columns_, column = k % columns_, row = k / columns_;
    return position(Vec2((column + 0.5) / columns_, (row + 0.5) / rows));
}

Vec3 LightSamples::position(const Vec2& uv) const {
    const auto& quad = std::get<QuadLight>(light_);
    return quad.corner + uv.x * quad.edge1 + uv.y * quad.edge2;
}

}  // namespace etalon
