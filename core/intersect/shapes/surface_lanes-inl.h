// surface() for several hits on one primitive, in the same steps and so with the same bits. What
// all points of a primitive have in common is taken from one of them. Compiled for each instruction
// set.
#if defined(ETALON_SURFACE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_SURFACE_LANES_INL_H
#undef ETALON_SURFACE_LANES_INL_H
#else
#define ETALON_SURFACE_LANES_INL_H
#endif

#include "core/intersect/shapes/box_lanes-inl.h"
#include "core/intersect/shapes/plane.h"
#include "core/intersect/shapes/thickness.h"
#include "core/intersect/shapes/triangle_lanes-inl.h"
#include "core/intersect/surface.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Hits with their rays; the directions are those of a RayQuery.
struct HitRays {
    Vec3Lanes origin, direction;
    Doubles t;

    HWY_INLINE Vec3Lanes point() const { return origin + t * direction; }
};

/// Points of hits, and which of them are decided. The shading normal is the normal.
struct SurfaceLanes {
    Vec3Lanes position, error, normal;
    DoubleMask decided;
};

HWY_INLINE DoubleMask all_decided() {
    return hn::FirstN(DoubleTag(), most_doubles);
}

/// Returns the hits for which is_distant() is false.
template <class Shape>
HWY_INLINE DoubleMask are_near(const Shape& shape, const HitRays& hits) {
    const Vec3Lanes way = abs(hits.t * hits.direction);
    return hn::Max(way.x, hn::Max(way.y, way.z)) <=
           broadcast(largest_thickness_ratio * thickness(shape));
}

HWY_INLINE SurfaceLanes surfaces(const Sphere& s, const SurfacePoint& any, const HitRays& hits) {
    const Vec3Lanes centre = broadcast(s.centre);
    const Vec3Lanes normal = normalized((hits.origin - centre) + hits.t * hits.direction);
    return {centre + broadcast(s.radius) * normal, broadcast(any.error), normal, are_near(s, hits)};
}

HWY_INLINE SurfaceLanes surfaces(const Plane& p, const SurfacePoint& any, const HitRays& hits) {
    const Vec3Lanes normal = broadcast(any.normal), point = broadcast(p.point);
    Vec3Lanes position = hits.point();
    position = position - normal.dot(position - point) * normal;
    const Vec3Lanes error = broadcast(64 * unit_roundoff) * (abs(position) + abs(point));
    const Doubles left = hn::Abs(normal.dot(position - point));
    const Doubles most_left = broadcast(most_left_of_distance) * abs(normal).dot(error);
    return {position, error, normal, left <= most_left};
}

/// Computes points of a polygon without corner normals.
HWY_INLINE SurfaceLanes surfaces(const StoredPolygon& p, const SurfacePoint& any,
                                 const HitRays& hits) {
    const Vec3Lanes normal = broadcast(any.normal);
    const Vec3Lanes point = broadcast(p.corners[0] + p.facts.plane.mean);
    const Vec3Lanes position = hits.point();
    return {position - normal.dot(position - point) * normal, broadcast(any.error), normal,
            all_decided()};
}

/// Computes points of a cone; that at an apex, and distant ones, are left undecided.
HWY_INLINE SurfaceLanes surfaces(const Cone& c, const SurfacePoint& any, const HitRays& hits) {
    const Doubles zero = broadcast(0), one = broadcast(1);
    const Vec3 axis = c.top - c.base;
    const double length = std::sqrt(axis.dot(axis)), spread = c.top_radius - c.base_radius;
    const Vec3Lanes h = broadcast(axis), base = broadcast(c.base);
    const Vec3Lanes w = (hits.origin - base) + hits.t * hits.direction;
    const Doubles along = w.dot(h) / broadcast(axis.dot(axis));
    const Doubles s = hn::IfThenElse(along < zero, zero, hn::IfThenElse(one < along, one, along));
    const Vec3Lanes radial = w - along * h;
    const Doubles distance = hn::Sqrt(radial.dot(radial));
    const Vec3Lanes outward = radial / distance;
    const Vec3Lanes tilt = broadcast((spread / length) * axis);
    const Vec3Lanes normal = normalized(broadcast(length) * outward - tilt);
    const Doubles radius = broadcast(c.base_radius) + s * broadcast(spread);
    return {base + s * h + radius * outward, broadcast(any.error), normal,
            hn::And(distance > zero, are_near(c, hits))};
}

/// Where lines cross the slabs of a box, one axis after another, and the axes of the last entries
/// and first exits: 0, 1 or 2.
struct BoxFaces {
    HWY_INLINE BoxFaces() : entry_axis(broadcast(0)), exit_axis(broadcast(0)) {}

    HWY_INLINE void cross(double min, double max, Doubles origin, Doubles direction, double axis) {
        const Doubles entry = crossing.entry, exit = crossing.exit;
        crossing.cross(min, max, origin, direction);
        entry_axis = hn::IfThenElse(crossing.entry > entry, broadcast(axis), entry_axis);
        exit_axis = hn::IfThenElse(crossing.exit < exit, broadcast(axis), exit_axis);
    }

    SlabCrossings crossing;
    Doubles entry_axis, exit_axis;
};

/// Sets one coordinate of a point on a box and of its normal. `is_face`: the point is on a face of
/// this axis, on the one at the slab's upper end where `at_max`.
HWY_INLINE void put_on_box(double min, double max, DoubleMask is_face, DoubleMask at_max,
                           Doubles& position, Doubles& normal) {
    const Doubles low = broadcast(min), high = broadcast(max);
    const Doubles inside =
        hn::IfThenElse(position < low, low, hn::IfThenElse(high < position, high, position));
    position = hn::IfThenElse(is_face, hn::IfThenElse(at_max, high, low), inside);
    normal = hn::IfThenElseZero(is_face, hn::IfThenElse(at_max, broadcast(1), broadcast(-1)));
}

HWY_INLINE SurfaceLanes surfaces(const Box& b, const SurfacePoint& any, const HitRays& hits) {
    const Vec3Lanes &o = hits.origin, &d = hits.direction;
    const Doubles zero = broadcast(0);
    BoxFaces faces;
    faces.cross(b.min.x, b.max.x, o.x, d.x, 0);
    faces.cross(b.min.y, b.max.y, o.y, d.y, 1);
    faces.cross(b.min.z, b.max.z, o.z, d.z, 2);
    const DoubleMask entering =
        hn::Abs(hits.t - faces.crossing.entry) <= hn::Abs(hits.t - faces.crossing.exit);
    const Doubles axis = hn::IfThenElse(entering, faces.entry_axis, faces.exit_axis);
    const auto at_max = [&](Doubles along) HWY_ATTR { return hn::Xor(along > zero, entering); };
    Vec3Lanes position = hits.point(), normal;
    put_on_box(b.min.x, b.max.x, axis == broadcast(0), at_max(d.x), position.x, normal.x);
    put_on_box(b.min.y, b.max.y, axis == broadcast(1), at_max(d.y), position.y, normal.y);
    put_on_box(b.min.z, b.max.z, axis == broadcast(2), at_max(d.z), position.z, normal.z);
    const DoubleMask runs_along = hn::Or(d.x == zero, hn::Or(d.y == zero, d.z == zero));
    return {position, broadcast(any.error), normal, hn::Not(runs_along)};
}

template <int dominant>
HWY_INLINE SurfaceLanes surfaces_along(const TriangleCorners& p, const SurfacePoint& any,
                                       const HitRays& hits) {
    const TriangleCrossings c(
        in_ray_frame<dominant>(broadcast(p[0])), in_ray_frame<dominant>(broadcast(p[1])),
        in_ray_frame<dominant>(broadcast(p[2])), in_ray_frame<dominant>(hits.origin),
        in_ray_frame<dominant>(hits.direction));
    const Doubles signed_sum = c.u + c.v + c.w;
    const DoubleMask is_back = signed_sum < broadcast(0);
    const auto turned = [&](Doubles x) HWY_ATTR { return hn::IfThenElse(is_back, hn::Neg(x), x); };
    const Doubles u = turned(c.u), v = turned(c.v), w = turned(c.w), sum = u + v + w;
    const Vec3Lanes position =
        (u / sum) * broadcast(p[0]) + (v / sum) * broadcast(p[1]) + (w / sum) * broadcast(p[2]);
    return {position, broadcast(any.error), broadcast(any.normal),
            c.surely_inside(hn::Abs(signed_sum))};
}

HWY_INLINE void replace(DoubleMask where, const SurfaceLanes& by, SurfaceLanes& surfaces) {
    const auto chosen = [&](Doubles yes, Doubles no)
                            HWY_ATTR { return hn::IfThenElse(where, yes, no); };
    surfaces.position = {chosen(by.position.x, surfaces.position.x),
                         chosen(by.position.y, surfaces.position.y),
                         chosen(by.position.z, surfaces.position.z)};
    surfaces.decided = hn::Or(hn::And(where, by.decided), hn::AndNot(where, surfaces.decided));
}

/// Computes points of a triangle without corner normals.
HWY_INLINE SurfaceLanes surfaces(const TriangleCorners& p, const SurfacePoint& any,
                                 const HitRays& hits) {
    const DoubleTag tag;
    const Vec3Lanes size = abs(hits.direction);
    const DoubleMask is_x = hn::And(size.x >= size.y, size.x >= size.z);
    const DoubleMask is_y = hn::AndNot(is_x, size.y >= size.z);
    const DoubleMask is_z = hn::Not(hn::Or(is_x, is_y));
    SurfaceLanes s{broadcast(any.position), broadcast(any.error), broadcast(any.normal),
                   hn::FirstN(tag, 0)};
    if (!hn::AllFalse(tag, is_x)) replace(is_x, surfaces_along<0>(p, any, hits), s);
    if (!hn::AllFalse(tag, is_y)) replace(is_y, surfaces_along<1>(p, any, hits), s);
    if (!hn::AllFalse(tag, is_z)) replace(is_z, surfaces_along<2>(p, any, hits), s);
    return s;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
