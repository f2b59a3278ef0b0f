#include "native_accel/grid/items.h"

#include "core/intersect/shapes/triangle.h"

namespace etalon {
namespace {

SphereItem sphere_item(const Scene& scene, const Frame& frame, const BoundedPrimitive& p) {
    const Sphere& s = scene.get<Sphere>(scene.primitives[p.id]);
    return {p.box(), p.id, frame.point(s.centre), s.radius * frame.scale()};
}

TriangleItem triangle_item(const Scene& scene, const Frame& frame, const BoundedPrimitive& p) {
    const auto exact = corners(scene, scene.get<Triangle>(scene.primitives[p.id]));
    return {
        p.box(),
        p.id,
        {Vec3f(frame.point(exact[0])), Vec3f(frame.point(exact[1])), Vec3f(frame.point(exact[2]))}};
}

}  // namespace

GridItems::GridItems(const Scene& scene, const SceneBounds& bounds) {
    for (const BoundedPrimitive& p : bounds.bounded) {
        const auto kind = static_cast<ShapeKind>(p.kind);
        if (kind == kind_of<Sphere>()) {
            spheres.push_back(sphere_item(scene, bounds.frame, p));
        } else if (kind == kind_of<Triangle>()) {
            triangles.push_back(triangle_item(scene, bounds.frame, p));
        } else {
            others.push_back({p.box(), p.id});
        }
    }
}

}  // namespace etalon
