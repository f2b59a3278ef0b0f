#include "core/intersect/kernels.h"

#include "core/intersect/shapes/all.h"

namespace etalon {

Box3 primitive_bounds(const Scene& scene, std::uint32_t primitive) {
    const Primitive& p = scene.primitives[primitive];
    return with_shape(p.kind, [&]<class Shape>() { return bounds(scene, scene.get<Shape>(p)); });
}

double primitive_first_hit(const Scene& scene, std::uint32_t primitive, const RayQuery& query) {
    if (primitive == query.ray.left) return no_hit;
    const Primitive& p = scene.primitives[primitive];
    return with_shape(p.kind, [&]<class Shape>() {
        return first_hit(scene, scene.get<Shape>(p), p.sides, query);
    });
}

template <class Shape>
double shape_first_hit(const Scene& scene, const Shape& shape, Sides sides, const RayQuery& query) {
    return first_hit(scene, shape, sides, query);
}
template double shape_first_hit(const Scene&, const Triangle&, Sides, const RayQuery&);
template double shape_first_hit(const Scene&, const Sphere&, Sides, const RayQuery&);

SurfacePoint surface_at(const Scene& scene, const Ray& ray, const Hit& hit) {
    const Primitive& p = scene.primitives[hit.primitive];
    const RayQuery query(ray);
    return with_shape(p.kind, [&]<class Shape>() {
        SurfacePoint point = surface(scene, scene.get<Shape>(p), query, hit.t);
        point.primitive = hit.primitive;
        point.form = Shape::form;
        return point;
    });
}

}  // namespace etalon
