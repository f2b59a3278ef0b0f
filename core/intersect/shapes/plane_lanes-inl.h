// first_hit() of a plane for several rays: see plane.h. Compiled for each instruction set.
#if defined(ETALON_PLANE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_PLANE_LANES_INL_H
#undef ETALON_PLANE_LANES_INL_H
#else
#define ETALON_PLANE_LANES_INL_H
#endif

#include "core/intersect/shapes/plane.h"
#include "core/intersect/shapes/ray_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

HWY_INLINE HitLanes first_hits(const Plane& p, Sides sides, const RayLanes& rays) {
    const Doubles zero = broadcast(0), good = broadcast(0.25);
    const Vec3Lanes n = broadcast(p.normal), offset = broadcast(p.point) - rays.origin;
    const Doubles cosine = n.dot(rays.direction), distance = n.dot(offset);
    const Doubles cosine_size = hn::Abs(cosine), distance_size = hn::Abs(distance);
    const Doubles cosine_scale = abs(n).dot(abs(rays.direction));
    const Doubles distance_scale = abs(n).dot(abs(offset));
    const DoubleMask certain =
        hn::And(hn::And(cosine_size > broadcast(4 * unit_roundoff) * cosine_scale,
                        distance_size > broadcast(5 * unit_roundoff) * distance_scale),
                hn::Min(cosine_scale, distance_scale) > broadcast(0x1p-900));
    const DoubleMask missed = hn::And(certain, hn::Xor(cosine > zero, distance > zero));
    const DoubleMask decided = hn::And(certain, hn::And(cosine_size >= good * cosine_scale,
                                                        distance_size >= good * distance_scale));
    const Doubles t = distance / cosine;
    DoubleMask is_seen = is_ahead(t, rays);
    if (sides != Sides::both) {
        is_seen = hn::And(is_seen, sides == Sides::front ? cosine < zero : cosine > zero);
    }
    return hit_lanes(hn::IfThenElse(is_seen, t, broadcast(no_hit)), missed, decided);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
