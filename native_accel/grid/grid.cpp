#include "native_accel/grid/grid.h"

#include "core/intersect/kernels.h"
#include "native_accel/grid/items.h"
#include "native_accel/grid/visit.h"

namespace etalon {
namespace {

/// FrameRay::tmax, up to a few units of rounding more, without a branch.
float end_of(const FrameRay& ray, double t) {
    constexpr float largest = std::numeric_limits<float>::max();
    const double end = std::min((t - ray.shift) * ray.scale, double(largest) / 2);
    const auto rounded = static_cast<float>(end);
    return rounded + (0x1p-22F * std::abs(rounded) + std::numeric_limits<float>::min());
}

}  // namespace

Grid::Grid(const Scene& scene) : Intersector(scene) {
    const GridItems items(scene, scene_bounds());
    take_bounded();  // which frees them
    spheres_ = PackedGrid<SpherePack>(items.spheres);
    triangles_ = PackedGrid<TrianglePack>(items.triangles);
    others_ = PackedGrid<BoxPack>(items.others);
}

std::size_t Grid::memory_bytes() const {
    return spheres_.memory_bytes() + triangles_.memory_bytes() + others_.memory_bytes();
}

void Grid::closest_bounded(const RayQuery& query, const FrameRay& local,
                           NearestHit& nearest) const {
    const GridRay ray(local);
    const float tmin = local.tmin(query.ray.tmin);
    float tmax = end_of(local, nearest.t);
    const auto offer = [&](std::uint32_t id) {
        const double before = nearest.t;
        nearest.offer(primitive_first_hit(scene(), id, query), id);
        if (nearest.t < before) tmax = end_of(local, nearest.t);
        return tmax;
    };
    visit<TrianglePackFilter>(triangles_, local, ray, tmin, tmax, offer);
    visit<SphereFilter>(spheres_, local, ray, tmin, tmax, offer);
    visit<BoxFilter>(others_, local, ray, tmin, tmax, offer);
}

bool Grid::occluded_bounded(const RayQuery& query, const FrameRay& local) const {
    const GridRay ray(local);
    const float tmin = local.tmin(query.ray.tmin), tmax = end_of(local, query.ray.tmax);
    bool found = false;
    const auto offer = [&](std::uint32_t id) {
        if (!found) found = primitive_first_hit(scene(), id, query) <= query.ray.tmax;
        return found ? -std::numeric_limits<float>::infinity() : tmax;
    };
    visit<SphereFilter>(spheres_, local, ray, tmin, tmax, offer);
    if (!found) visit<TrianglePackFilter>(triangles_, local, ray, tmin, tmax, offer);
    if (!found) visit<BoxFilter>(others_, local, ray, tmin, tmax, offer);
    return found;
}

}  // namespace etalon
