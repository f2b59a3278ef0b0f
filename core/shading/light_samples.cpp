#include "core/shading/light_samples.h"

#include <cmath>

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shading/light_samples.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/vec_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Writes the points of a quad by the steps of LightSamples::position(), padding included.
void find_positions(const QuadLight& quad, std::span<const Vec2> uvs, const MutableVec3Span& to) {
    const Vec3Lanes corner = broadcast(quad.corner);
    const Vec3Lanes edge1 = broadcast(quad.edge1), edge2 = broadcast(quad.edge2);
    for (std::size_t i = 0; i < uvs.size(); i += hn::Lanes(DoubleTag())) {
        const Vec2Lanes uv = load(&uvs[i]);
        store(corner + uv.x * edge1 + uv.y * edge2, to, i);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(find_positions);

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

void LightSamples::find_positions(std::span<const Vec2> uvs, Vec3Buffer& positions) const {
    positions.make_room(uvs.size());
    HWY_DYNAMIC_DISPATCH(find_positions)
    (std::get<QuadLight>(light_), uvs, positions.span());
}

Vec3 LightSamples::position(const Vec2& uv) const {
    const auto& quad = std::get<QuadLight>(light_);
    return quad.corner + uv.x * quad.edge1 + uv.y * quad.edge2;
}

}  // namespace etalon
#endif
