#include "core/oracle/enclosure.h"

#include <algorithm>
#include <cmath>

#include "core/intersect/kernels.h"

namespace etalon {
namespace {

Box3 around(const Vec3& centre, const Vec3& reach) {
    return {centre - reach, centre + reach};
}

/// Returns a box around the image of all points with |x|, |y| <= `across` and |z| <= `up`.
Box3 image(const Affine& map, double across, double up) {
    return around(map.origin, across * (abs(map.x) + abs(map.y)) + up * abs(map.z));
}

template <class Corners>
Box3 hull(const Corners& corners) {
    Box3 box;
    for (const Vec3& p : corners) box.extendBy(p);
    return box;
}

Box3 enclose(const Geometry&, const Sphere& s) {
    return around(s.centre, Vec3(s.radius));
}

Box3 enclose(const Geometry& geometry, const Triangle& t) {
    Box3 box;
    for (const std::uint32_t corner : t.vertices) box.extendBy(geometry.vertex(corner));
    return box;
}

Box3 enclose(const Geometry&, const Polygon& polygon) {
    return hull(polygon.corners);
}

Box3 enclose(const Geometry&, const Box& box) {
    return {box.min, box.max};
}

Box3 enclose(const Geometry&, const Plane&) {
    return {Vec3(-infinity), Vec3(infinity)};
}

Box3 enclose(const Geometry&, const Cone& c) {
    const Vec3 reach(std::max(c.base_radius, c.top_radius));
    Box3 box = around(c.base, reach);
    box.extendBy(around(c.top, reach));
    return box;
}

Box3 enclose(const Geometry&, const Ring& r) {
    return around(r.centre, Vec3(r.outer));
}

Box3 enclose(const Geometry&, const Quadric& q) {
    return q.clip;
}

Box3 enclose(const Geometry&, const Ellipsoid& e) {
    return image(e.to_world, 1, 1);
}

Box3 enclose(const Geometry&, const ClosedCylinder& c) {
    return image(c.to_world, 1, 1);
}

Box3 enclose(const Geometry&, const Revolved& s) {
    const Profile& p = s.profile;
    const double far = std::max(std::abs(p.low), std::abs(p.high));
    if (p.is_flat()) return image(s.to_world, far, 0);
    const auto& [q0, q1, q2] = p.squares;
    return image(s.to_world, std::sqrt(std::abs(q0) + far * (std::abs(q1) + far * std::abs(q2))),
                 far);
}

}  // namespace

/// The kernel of a curve is its definition, with its roundings and their bounds.
Box3 enclosure(const Geometry& geometry, std::uint32_t primitive) {
    const Primitive p = geometry.primitives[primitive];
    return with_shape(p.kind, [&]<class Shape>() {
        if constexpr (std::is_same_v<Shape, Curve>) {
            return primitive_bounds(geometry, primitive);
        } else {
            return enclose(geometry, geometry.get<Shape>(p));
        }
    });
}

}  // namespace etalon
