#include "core/intersect/kernels.h"

#include "core/intersect/cut_outs.h"
#include "core/intersect/distant_surface.h"
#include "core/intersect/placement.h"
#include "core/intersect/rescaled_ray.h"
#include "core/intersect/shapes/all_shapes.h"

namespace etalon {

Box3 primitive_bounds(const Geometry& geometry, std::uint32_t primitive) {
    const Primitive p = geometry.primitives[primitive];
    return with_shape(p.kind,
                      [&]<class Shape>() { return bounds(geometry, geometry.get<Shape>(p)); });
}

Box3 widened(const Box3& box) {
    if (box.isEmpty()) return box;
    Box3 wide = box;
    for (int k = 0; k < 3; ++k) {
        const double largest = std::max(std::abs(box.min[k]), std::abs(box.max[k]));
        const double margin = 8 * unit_roundoff * largest;
        wide.min[k] -= margin;
        wide.max[k] += margin;
    }
    return wide;
}

namespace {

/// True if the faces of a shape's box are the shape's own numbers, not sums.
template <class Shape>
constexpr bool has_exact_bounds =
    std::is_same_v<Shape, Triangle> || std::is_same_v<Shape, Polygon> ||
    std::is_same_v<Shape, Box> || std::is_same_v<Shape, Plane> || std::is_same_v<Shape, Quadric>;

}  // namespace

Box3 whole_bounds(const Geometry& geometry, std::uint32_t primitive) {
    const Primitive p = geometry.primitives[primitive];
    return with_shape(p.kind, [&]<class Shape>() {
        const Box3 box = bounds(geometry, geometry.get<Shape>(p));
        return has_exact_bounds<Shape> ? box : widened(box);
    });
}

namespace {

/// Calls a shape's kernel. Kept out of line, so that kernels of few registers, such as a sphere's,
/// do not set up the stack frame of the largest.
template <class Shape>
[[gnu::noinline]] double first_hit_of(const Geometry& geometry, Primitive p,
                                      const RayQuery& query) {
    return first_hit(geometry, geometry.get<Shape>(p), p.sides, query);
}

/// Tests a cut-out triangle. A line meets a triangle once, so nothing of it is behind a hole.
[[gnu::noinline]] double cut_out_first_hit(const Geometry& geometry, std::uint32_t primitive,
                                           const RayQuery& query) {
    const auto triangle = geometry.get<Triangle>(geometry.primitives[primitive]);
    const double t = first_hit(geometry, triangle, Sides::both, query);
    return t <= query.ray.tmax && meets_hole(geometry, primitive, query) ? no_hit : t;
}

}  // namespace

bool meets_hole(const Geometry& geometry, std::uint32_t primitive, const RayQuery& query) {
    if (!geometry.cut_outs) return false;
    const Primitive p = geometry.primitives[primitive];
    SurfacePoint point = surface(geometry, geometry.get<Triangle>(p), query, 0);
    point.primitive = primitive;
    point.material = p.material;
    return geometry.cut_outs->is_hole(geometry, point, query.ray.is_shadow());
}

double primitive_first_hit(const Geometry& geometry, std::uint32_t primitive,
                           const RayQuery& query) {
    if (primitive == query.ray.exclude) return no_hit;
    const Primitive p = geometry.primitives[primitive];
    if (p.sides == Sides::cut_out) [[unlikely]]
        return cut_out_first_hit(geometry, primitive, query);
    return with_shape(p.kind,
                      [&]<class Shape>() { return first_hit_of<Shape>(geometry, p, query); });
}

template <class Shape>
double shape_first_hit(const Geometry& geometry, const Shape& shape, Sides sides,
                       const RayQuery& query) {
    return first_hit(geometry, shape, sides, query);
}
template double shape_first_hit(const Geometry&, const Triangle&, Sides, const RayQuery&);
template double shape_first_hit(const Geometry&, const Sphere&, Sides, const RayQuery&);

namespace {

/// True if rays into a shape that leave from next to an edge may start beyond another of its faces.
template <class Shape>
concept HasEdges = requires(const Shape& shape, const Vec3& distance, SurfacePoint& p) {
    { move_off_edges(shape, distance, p) } -> std::same_as<bool>;
};

/// Moves a point of an object's shape away from its edges, so that a ray into the shape also starts
/// inside its other faces. `point` is `local` in world space. Returns whether it was moved.
bool move_off_edges(const Geometry& object, const Instance& instance, const SurfacePoint& point,
                    SurfacePoint& local) {
    const Primitive p = object.primitives[local.primitive];
    return with_shape(p.kind, [&]<class Shape>() {
        if constexpr (HasEdges<Shape>) {
            const Vec3 drift = drift_of_origins(instance, local, point);
            return move_off_edges(object.get<Shape>(p), drift, local);
        } else {
            return false;
        }
    });
}

/// Calls a shape's surface(), or the slow distant_surface() where the hit is far away.
template <class Shape>
SurfacePoint surface_of(const Geometry& geometry, const Shape& shape, Sides sides,
                        const RayQuery& query, double t) {
    if constexpr (HasThickness<Shape>) {
        if (is_distant(shape, query.ray, t)) [[unlikely]]
            return distant_surface(geometry, shape, sides, query.ray, t);
    }
    return surface(geometry, shape, query, t);
}

/// Returns a point of an instance. Kept out of line, so that points of the scene itself do not pay
/// for it.
[[gnu::noinline]] SurfacePoint surface_of_instance(const Geometry& geometry, const Ray& ray,
                                                   const Hit& hit) {
    if (has_extreme_direction(ray)) {
        const RescaledRay usual(ray);
        const Hit same{hit.t / usual.unit, hit.primitive, hit.instance};
        return surface_of_instance(geometry, usual.ray, same);
    }
    const InstanceAt instance(geometry, hit.instance, ray.time());
    const Geometry& object = geometry.objects[instance->object];
    SurfacePoint local = surface_at(object, to_object(*instance, hit.instance, RayQuery(ray).ray),
                                    {hit.t, hit.primitive});
    SurfacePoint point = placed(*instance, local);
    if (move_off_edges(object, *instance, point, local)) point = placed(*instance, local);
    point.instance = hit.instance;
    return point;
}

}  // namespace

SurfacePoint surface_at(const Geometry& geometry, const Ray& ray, const Hit& hit) {
    if (hit.instance != no_index) return surface_of_instance(geometry, ray, hit);
    const Primitive p = geometry.primitives[hit.primitive];
    const RayQuery query(ray);
    return with_shape(p.kind, [&]<class Shape>() {
        SurfacePoint point = surface_of(geometry, geometry.get<Shape>(p), p.sides, query, hit.t);
        point.primitive = hit.primitive;
        point.material = p.material;
        point.convexity = Shape::convexity;
        point.time = ray.time();
        return point;
    });
}

}  // namespace etalon
