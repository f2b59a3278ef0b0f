#include "core/intersect/normal_change.h"

#include "core/intersect/placement.h"
#include "core/intersect/shapes/all_shapes.h"

namespace etalon {
namespace {

/// Returns the derivative of a vector's direction, given that of the vector.
Vec3 change_of_direction(const Vec3& vector, const Vec3& change) {
    const double length = vector.length();
    if (!(length > 0)) return Vec3(0);
    const Vec3 direction = vector / length;
    return (change - direction.dot(change) * direction) / length;
}

template <class Shape>
Vec3 change(const Geometry&, const Shape&, const SurfacePoint&, const Vec3&) {
    return Vec3(0);
}

Vec3 change(const Geometry&, const Sphere& s, const SurfacePoint& p, const Vec3& along) {
    return change_of_direction(s.radius * p.normal, along);
}

Vec3 change(const Geometry&, const Ellipsoid& e, const SurfacePoint& p, const Vec3& along) {
    const Vec3 local = e.frame.vector(p.position - e.to_world.origin);
    return change_of_direction(e.frame.normal(local), e.frame.normal(e.frame.vector(along)));
}

/// The gradient is an affine function of the point.
Vec3 change(const Geometry&, const Revolved& s, const SurfacePoint& p, const Vec3& along) {
    const Vec3 local = s.frame.vector(p.position - s.to_world.origin);
    const Vec3 here = gradient(s.profile, local);
    const Vec3 there = gradient(s.profile, local + s.frame.vector(along));
    return change_of_direction(s.frame.normal(here), s.frame.normal(there - here));
}

Vec3 change(const Geometry& geometry, const Triangle& t, const SurfacePoint& p, const Vec3& along) {
    if (t.normal_offset == no_index) return Vec3(0);
    const TriangleCorners corner(geometry, t);
    const Vec3 a = corner[1] - corner[0], b = corner[2] - corner[0], area = a.cross(b);
    const double to1 = along.cross(b).dot(area), to2 = a.cross(along).dot(area);
    const auto normal = [&](std::size_t k) {
        return geometry.normals[Geometry::normal_number(t, k)];
    };
    const auto weight = [&](const Vec3& from, const Vec3& to) {
        return (from - p.position).cross(to - p.position).dot(area);
    };
    const Vec3 mean = weight(corner[1], corner[2]) * normal(0) +
                      weight(corner[2], corner[0]) * normal(1) +
                      weight(corner[0], corner[1]) * normal(2);
    return change_of_direction(mean, to1 * (normal(1) - normal(0)) + to2 * (normal(2) - normal(0)));
}

}  // namespace

Vec3 normal_change(const Geometry& geometry, const SurfacePoint& point, const Vec3& along) {
    if (point.instance != no_index) {
        const InstanceAt instance(geometry, point.instance, point.time);
        const SurfacePoint local = local_point(*instance, point);
        const Vec3 local_change = normal_change(geometry.objects[instance->object], local,
                                                vector_to_object(*instance, along));
        return change_of_direction(normal_to_world(*instance, local.shading_normal),
                                   normal_to_world(*instance, local_change));
    }
    const Primitive p = geometry.primitives[point.primitive];
    return with_shape(p.kind, [&]<class Shape>() {
        return change(geometry, geometry.get<Shape>(p), point, along);
    });
}

}  // namespace etalon
