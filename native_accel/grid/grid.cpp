#include "native_accel/grid/grid.h"

#include "core/intersect/kernels.h"
#include "core/intersect/shapes/triangle.h"

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
    spheres_ = PackedGrid<SpherePack, SphereFilter>(spheres);
    triangles_ = PackedGrid<TrianglePack, TrianglePackFilter>(triangles);
    others_ = PackedGrid<BoxPack, BoxFilter>(others);
}

std::size_t Grid::memory_bytes() const {
    return spheres_.memory_bytes() + triangles_.memory_bytes() + others_.memory_bytes();
}

void Grid::closest_bounded(const RayQuery& query, const FrameRay& local,
                           NearestHit& nearest) const {
    const GridRay ray(local);
    const float tmin = local.tmin(query.ray.tmin);
    float tmax = local.tmax(nearest.t);
    const auto offer = [&](std::uint32_t id) {
        const double before = nearest.t;
        nearest.offer(primitive_first_hit(scene(), id, query), id);
        if (nearest.t < before) tmax = local.tmax(nearest.t);
        return tmax;
    };
    triangles_.visit(local, ray, tmin, tmax, offer);
    spheres_.visit(local, ray, tmin, tmax, offer);
    others_.visit(local, ray, tmin, tmax, offer);
}

bool Grid::occluded_bounded(const RayQuery& query, const FrameRay& local) const {
    const GridRay ray(local);
    const float tmin = local.tmin(query.ray.tmin), tmax = local.tmax(query.ray.tmax);
    bool found = false;
    const auto offer = [&](std::uint32_t id) {
        if (!found) found = primitive_first_hit(scene(), id, query) <= query.ray.tmax;
        return found ? -std::numeric_limits<float>::infinity() : tmax;
    };
    spheres_.visit(local, ray, tmin, tmax, offer);
    if (!found) triangles_.visit(local, ray, tmin, tmax, offer);
    if (!found) others_.visit(local, ray, tmin, tmax, offer);
    return found;
}

}  // namespace etalon
