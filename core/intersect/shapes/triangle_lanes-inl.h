// first_hit() of a triangle for several rays of one dominant axis: see triangle.h. Compiled for
// each instruction set.
#if defined(ETALON_TRIANGLE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_TRIANGLE_LANES_INL_H
#undef ETALON_TRIANGLE_LANES_INL_H
#else
#define ETALON_TRIANGLE_LANES_INL_H
#endif

#include "core/intersect/shapes/ray_lanes-inl.h"
#include "core/intersect/shapes/triangle.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Returns the components of vectors in the rays' frame: z along their dominant axis.
template <int dominant>
HWY_INLINE Vec3Lanes in_ray_frame(const Vec3Lanes& v) {
    if constexpr (dominant == 0) return {v.y, v.z, v.x};
    if constexpr (dominant == 1) return {v.z, v.x, v.y};
    return v;
}

/// Computes shear(); all arguments in the rays' frame.
HWY_INLINE Vec3Lanes shear(const Vec3Lanes& corner, const Vec3Lanes& origin, const Vec3Lanes& d) {
    const Vec3Lanes a = corner - origin;
    return {d.z * a.x - d.x * a.z, d.z * a.y - d.y * a.z, a.z};
}

HWY_INLINE Doubles edge_function(const Vec3Lanes& a, const Vec3Lanes& b) {
    return a.x * b.y - a.y * b.x;
}

/// Performs cross_triangle(), as far as doubles decide.
struct TriangleCrossings {
    /// All arguments are in the rays' frame: corners, origins and directions.
    HWY_INLINE TriangleCrossings(const Vec3Lanes& p, const Vec3Lanes& q, const Vec3Lanes& r,
                                 const Vec3Lanes& o, const Vec3Lanes& d)
        : a(shear(p, o, d)), b(shear(q, o, d)), c(shear(r, o, d)) {
        u = edge_function(b, c);
        v = edge_function(c, a);
        w = edge_function(a, b);
        // See edge_error().
        const Doubles extent = hn::Max(max_abs(a.x, b.x, c.x), max_abs(a.y, b.y, c.y));
        deepest = max_abs(a.z, b.z, c.z);
        const Doubles e = broadcast(5 * unit_roundoff) * (extent + hn::Abs(d.z) * deepest);
        error_bound = e * (broadcast(5) * extent + broadcast(2) * e);
        least = hn::Min(u, hn::Min(v, w));
        most = hn::Max(u, hn::Max(v, w));
    }

    HWY_INLINE DoubleMask surely_outside() const {
        return hn::And(least<hn::Neg(error_bound), most> error_bound);
    }

    /// `size` is the magnitude of the weights' sum.
    HWY_INLINE DoubleMask surely_inside(Doubles size) const {
        return hn::And(hn::Or(least > error_bound, most < hn::Neg(error_bound)),
                       size > broadcast(0x1p28) * error_bound);
    }

    Vec3Lanes a, b, c;  ///< sheared corners
    Doubles u, v, w;    ///< their weights
    Doubles deepest, error_bound, least, most;
};

template <int dominant>
HWY_INLINE HitLanes first_hits(const TriangleCorners& p, Sides sides, const RayLanes& rays) {
    const Vec3Lanes d = in_ray_frame<dominant>(rays.direction);
    const TriangleCrossings crossing(
        in_ray_frame<dominant>(broadcast(p[0])), in_ray_frame<dominant>(broadcast(p[1])),
        in_ray_frame<dominant>(broadcast(p[2])), in_ray_frame<dominant>(rays.origin), d);
    const DoubleMask missed = crossing.surely_outside();
    if (hn::AllTrue(DoubleTag(), missed)) return misses();

    const auto& [a, b, c, u, v, w, deepest, error_bound, least, most] = crossing;
    const Doubles zero = broadcast(0), sum = u + v + w, size = hn::Abs(sum);
    const DoubleMask is_inside = crossing.surely_inside(size);
    // See distance_of().
    const Doubles depth = (u * a.z + v * b.z + w * c.z) / sum, t = depth / d.z;
    const Doubles spread = hn::Max(a.z, hn::Max(b.z, c.z)) - hn::Min(a.z, hn::Min(b.z, c.z));
    const Doubles depth_error =
        broadcast(4) * error_bound / size * spread + broadcast(8 * unit_roundoff) * deepest;
    const DoubleMask is_good = hn::Or(depth_error <= broadcast(t_tolerance) * hn::Abs(depth),
                                      hn::And(t<zero, hn::Abs(depth)> depth_error));
    DoubleMask is_seen = is_ahead(t, rays);
    if (sides != Sides::both) {
        const Doubles cosine = sum / d.z;
        is_seen = hn::And(is_seen, sides == Sides::front ? cosine < zero : cosine > zero);
    }
    return hit_lanes(hn::IfThenElse(is_seen, t, broadcast(no_hit)), missed,
                     hn::And(is_inside, is_good));
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
