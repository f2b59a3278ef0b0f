#include "native_accel/grid/grid.h"

#include "core/intersect/kernels.h"
#include "core/intersect/shapes/triangle.h"
#include "native_accel/grid/visit.h"

namespace etalon {
namespace {

TriangleItem triangle_item(const Scene& scene, const Frame& frame, const BoundedPrimitive& p) {
    const auto exact = corners(scene, scene.get<Triangle>(scene.primitives[p.id]));
    return {
        p.box,
        p.id,
        {Vec3f(frame.point(exact[0])), Vec3f(frame.point(exact[1])), Vec3f(frame.point(exact[2]))}};
}

SphereItem sphere_item(const Scene& scene, const Frame& frame, const BoundedPrimitive& p) {
    const Sphere& s = scene.get<Sphere>(scene.primitives[p.id]);
    return {p.box, p.id, frame.point(s.centre), s.radius * frame.scale()};
}

/// FrameRay::tmax, up to a few units of rounding more, without a branch.
float end_of(const FrameRay& ray, double t) {
    constexpr float largest = std::numeric_limits<float>::max();
    const double end = std::min((t - ray.shift) * ray.scale, double(largest) / 2);
    const auto rounded = static_cast<float>(end);
    return rounded + (0x1p-22F * std::abs(rounded) + std::numeric_limits<float>::min());
}

}  // namespace

Grid::Grid(const Scene& scene) : Intersector(scene) {
    std::vector<SphereItem> spheres;
    std::vector<TriangleItem> triangles;
    std::vector<BoxItem> others;
    const Frame& frame = scene_bounds().frame;
    for (const BoundedPrimitive& p : take_bounded()) {
        const ShapeKind kind = scene.primitives[p.id].kind;
        if (kind == kind_of<Sphere>()) {
            spheres.push_back(sphere_item(scene, frame, p));
        } else if (kind == kind_of<Triangle>()) {
            triangles.push_back(triangle_item(scene, frame, p));
        } else {
            others.push_back({p.box, p.id});
        }
    }
    spheres_ = PackedGrid<SpherePack>(spheres);
    triangles_ = PackedGrid<TrianglePack>(triangles);
    others_ = PackedGrid<BoxPack>(others);
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
