#include "core/intersect/object_outline.h"

#include <limits>

#include "core/intersect/kernels.h"
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/intersect/object_outline.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// The three axes side by side, and a number that is not used.
using Axes = double __attribute__((vector_size(32)));

/// Performs the steps of Affine::point() and Affine::vector(), for each part.
Box3 box_of_images(const Affine& map, std::span<const ObjectOutline::Part> parts) {
    const auto& [x, y, z, origin] = map;
    const Axes columns[] = {{x.x, x.y, x.z}, {y.x, y.y, y.z}, {z.x, z.y, z.z}};
    const Vec3 sizes[] = {abs(x), abs(y), abs(z)};
    const Axes magnitudes[] = {{sizes[0].x, sizes[0].y, sizes[0].z},
                               {sizes[1].x, sizes[1].y, sizes[1].z},
                               {sizes[2].x, sizes[2].y, sizes[2].z}};
    const Axes offset = {origin.x, origin.y, origin.z};
    constexpr double most = std::numeric_limits<double>::max();
    Axes min = {most, most, most}, max = -min;
    for (const auto& [centre, half] : parts) {
        const Axes middle =
            centre.x * columns[0] + centre.y * columns[1] + centre.z * columns[2] + offset;
        const Axes reach = half.x * magnitudes[0] + half.y * magnitudes[1] + half.z * magnitudes[2];
        const Axes low = middle - reach, high = middle + reach;
        min = low < min ? low : min;
        max = high > max ? high : max;
    }
    return {{min[0], min[1], min[2]}, {max[0], max[1], max[2]}};
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(box_of_images);

namespace {

Box3 box_of(const Geometry& object) {
    Box3 all;
    for (std::uint32_t id = 0; id < object.primitives.size(); ++id) {
        all.extendBy(whole_bounds(object, id));
    }
    return all;
}

}  // namespace

ObjectOutline::ObjectOutline(const Geometry& object) {
    const Box3 all = box_of(object);
    is_unbounded_ = !all.isEmpty() && !(is_finite(all.min) && is_finite(all.max));
    if (all.isEmpty() || is_unbounded_) return;
    const Vec3 middle = all.center();
    std::array<Box3, 8> octants;
    for (std::uint32_t id = 0; id < object.primitives.size(); ++id) {
        const Box3 box = whole_bounds(object, id);
        if (box.isEmpty()) continue;
        const Vec3 c = box.center();
        octants[(c.x < middle.x ? 1U : 0U) + (c.y < middle.y ? 2U : 0U) +
                (c.z < middle.z ? 4U : 0U)]
            .extendBy(box);
    }
    for (const Box3& box : octants) {
        if (!box.isEmpty()) parts_.push_back({box.center(), box.size() / 2});
    }
}

Box3 ObjectOutline::image(const Affine& map) const {
    return HWY_DYNAMIC_DISPATCH(box_of_images)(map, parts_);
}

}  // namespace etalon
#endif
