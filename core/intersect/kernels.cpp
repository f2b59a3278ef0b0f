#include "core/intersect/kernels.h"

#include "core/intersect/placement.h"
#include "core/intersect/shapes/all_shapes.h"

namespace etalon {

Box3 primitive_bounds(const Geometry& geometry, std::uint32_t primitive) {
    const Primitive p = geometry.primitives[primitive];
    return with_shape(p.kind,
                      [&]<class Shape>() { return bounds(geometry, geometry.get<Shape>(p)); });
}

namespace {

/// Calls a shape's kernel. Kept out of line, so that a kernel of few registers, a sphere's, does
/// not pay for the frame of the largest.
template <class Shape>
[[gnu::noinline]] double first_hit_of(const Geometry& geometry, Primitive p,
                                      const RayQuery& query) {
    return first_hit(geometry, geometry.get<Shape>(p), p.sides, query);
}

}  // namespace

double primitive_first_hit(const Geometry& geometry, std::uint32_t primitive,
                           const RayQuery& query) {
    if (primitive == query.ray.exclude) return no_hit;
    const Primitive p = geometry.primitives[primitive];
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

SurfacePoint surface_at(const Geometry& geometry, const Ray& ray, const Hit& hit) {
    if (hit.instance != no_index) {
        const Instance& instance = geometry.instances[hit.instance];
        SurfacePoint point = placed(
            instance, surface_at(geometry.objects[instance.object],
                                 to_object(instance, RayQuery(ray).ray), {hit.t, hit.primitive}));
        point.instance = hit.instance;
        return point;
    }
    const Primitive p = geometry.primitives[hit.primitive];
    const RayQuery query(ray);
    return with_shape(p.kind, [&]<class Shape>() {
        SurfacePoint point = surface(geometry, geometry.get<Shape>(p), query, hit.t);
        point.primitive = hit.primitive;
        point.material = p.material;
        point.convexity = Shape::convexity;
        return point;
    });
}

}  // namespace etalon
