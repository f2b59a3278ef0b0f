#include "core/intersect/near_region.h"

#include <vector>

#include "core/intersect/kernels.h"
#include "core/numerics/median.h"

namespace etalon {
namespace {

constexpr std::size_t largest_sample = 1024;

/// Returns a point of an item. Infinite or NaN where there is none of use.
Vec3 point_of(const Geometry& geometry, std::uint32_t item) {
    if (geometry.is_instance(item)) {
        return geometry.instances[item - geometry.primitives.size()].origin;
    }
    const Box3 box = whole_bounds(geometry, item);
    return box.isEmpty() ? Vec3(nan_value) : 0.5 * box.min + 0.5 * box.max;
}

}  // namespace

Vec3 middle_of(const Geometry& geometry) {
    const std::size_t step = geometry.item_count() / largest_sample + 1;
    std::vector<double> x, y, z;
    for (std::size_t item = 0; item < geometry.item_count(); item += step) {
        const Vec3 point = point_of(geometry, static_cast<std::uint32_t>(item));
        if (!is_finite(point)) continue;
        x.push_back(point.x);
        y.push_back(point.y);
        z.push_back(point.z);
    }
    if (x.empty()) return Vec3(0);
    return {median_of(std::move(x)), median_of(std::move(y)), median_of(std::move(z))};
}

}  // namespace etalon
