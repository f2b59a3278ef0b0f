// Code that the kernels for several rays at once share. They perform the steps of their shape's
// first_hit(), with the same bits, as long as plain doubles decide. Rays for which they do not are
// left to first_hit(). Compiled for each instruction set.
#if defined(ETALON_RAY_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_RAY_LANES_INL_H
#undef ETALON_RAY_LANES_INL_H
#else
#define ETALON_RAY_LANES_INL_H
#endif

#include "core/intersect/ray_packet.h"
#include "core/numerics/vec_lanes-inl.h"
#include "core/scene/primitive_runs.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Rays of a packet.
struct RayLanes {
    HWY_INLINE RayLanes(const RayPacket& packet, std::size_t first)
        : origin(load(packet.origins, first)),
          direction(load(packet.directions, first)),
          tmin(hn::LoadU(DoubleTag(), &packet.tmins[first])) {}

    Vec3Lanes origin, direction;
    Doubles tmin;
};

/// Result for each ray: t, NaN where the ray misses, and whether first_hit() must decide instead.
struct HitLanes {
    Doubles t;
    DoubleMask uncertain;
};

HWY_INLINE HitLanes misses() {
    return {broadcast(no_hit), hn::FirstN(DoubleTag(), 0)};
}

/// Returns no answer for any ray.
HWY_INLINE HitLanes all_uncertain() {
    return {broadcast(no_hit), hn::FirstN(DoubleTag(), most_doubles)};
}

/// Returns `t` for the rays for which the steps `decided`, and a miss for those that `missed`
/// before.
HWY_INLINE HitLanes hit_lanes(Doubles t, DoubleMask missed, DoubleMask decided) {
    const DoubleMask known = hn::Or(missed, decided);
    return {hn::IfThenElse(hn::AndNot(missed, decided), t, broadcast(no_hit)), hn::Not(known)};
}

HWY_INLINE DoubleMask is_ahead(Doubles t, const RayLanes& rays) {
    return hn::And(t > rays.tmin, t < broadcast(infinity));
}

/// See first_visible() in roots.h.
HWY_INLINE Doubles first_visible(Doubles entry, Doubles exit, Sides sides, const RayLanes& rays) {
    Doubles t = broadcast(no_hit);
    if (sides != Sides::front) t = hn::IfThenElse(is_ahead(exit, rays), exit, t);
    if (sides != Sides::back) t = hn::IfThenElse(is_ahead(entry, rays), entry, t);
    return t;
}

HWY_INLINE Doubles max_abs(Doubles x, Doubles y, Doubles z) {
    return hn::Max(hn::Abs(x), hn::Max(hn::Abs(y), hn::Abs(z)));
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
