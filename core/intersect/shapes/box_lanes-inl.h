// first_hit() of a box for several rays: see box.h. Compiled for each instruction set.
#if defined(ETALON_BOX_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_BOX_LANES_INL_H
#undef ETALON_BOX_LANES_INL_H
#else
#define ETALON_BOX_LANES_INL_H
#endif

#include "core/intersect/shapes/box.h"
#include "core/intersect/shapes/ray_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// The intervals of lines inside the slabs of a box. A line that is parallel to a slab and outside
/// it gets an empty interval far away.
struct SlabCrossings {
    HWY_INLINE SlabCrossings() : entry(broadcast(-infinity)), exit(broadcast(infinity)) {}

    HWY_INLINE void cross(double min, double max, Doubles origin, Doubles direction) {
        const Doubles low = broadcast(min), high = broadcast(max), inf = broadcast(infinity);
        const Doubles to_min = (low - origin) / direction, to_max = (high - origin) / direction;
        const DoubleMask runs_along = direction == hn::Zero(DoubleTag());
        const DoubleMask outside = hn::And(runs_along, hn::Or(origin<low, origin> high));
        const Doubles near = hn::IfThenElse(runs_along, hn::Neg(inf), hn::Min(to_min, to_max));
        const Doubles far = hn::IfThenElse(runs_along, inf, hn::Max(to_min, to_max));
        entry = hn::IfThenElse(outside, inf, hn::Max(entry, near));
        exit = hn::IfThenElse(outside, hn::Neg(inf), hn::Min(exit, far));
    }

    Doubles entry, exit;
};

HWY_INLINE HitLanes first_hits(const Box& b, Sides sides, const RayLanes& rays) {
    if (is_degenerate(b)) return misses();
    SlabCrossings c;
    c.cross(b.min.x, b.max.x, rays.origin.x, rays.direction.x);
    c.cross(b.min.y, b.max.y, rays.origin.y, rays.direction.y);
    c.cross(b.min.z, b.max.z, rays.origin.z, rays.direction.z);
    const Doubles error_bound = broadcast(3 * unit_roundoff) * (hn::Abs(c.entry) + hn::Abs(c.exit));
    const DoubleMask missed =
        hn::Or(hn::Not(c.entry - c.exit <= error_bound), c.entry == broadcast(infinity));
    return hit_lanes(first_visible(c.entry, c.exit, sides, rays), missed,
                     c.exit - c.entry > error_bound);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
