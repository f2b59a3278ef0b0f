#include "core/shading/leaving_rays.h"

#include <algorithm>

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shading/leaving_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/vec_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Some surfaces of a chunk.
struct LeftSurfaces {
    Vec3Lanes direction, position, error, normal, near_normal;
};

HWY_INLINE Vec3Lanes chosen(DoubleMask mask, const Vec3Lanes& yes, const Vec3Lanes& no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
            hn::IfThenElse(mask, yes.z, no.z)};
}

HWY_INLINE Doubles clamped_to_one(Doubles x) {
    const Doubles zero = broadcast(0), one = broadcast(1);
    return hn::IfThenElse(x < zero, zero, hn::IfThenElse(one < x, one, x));
}

/// The steps of spawn_ray(), or those of a fixed bias.
HWY_INLINE void store_way(const LeftSurfaces& s, const Vec3Lanes& direction, double bias,
                          std::size_t i, LeavingRays::Way& way) {
    const Doubles outward = s.normal.dot(direction), one = broadcast(1);
    store(direction, &way.directions[i]);
    hn::StoreU(outward, DoubleTag(), &way.outwards[i]);
    if (bias != 0) {
        store(s.position + broadcast(bias) * s.near_normal, &way.origins[i]);
        return;
    }
    const Doubles side = hn::IfThenElse(outward < broadcast(0), hn::Neg(one), one);
    const Vec3Lanes offset = (side * abs(s.normal).dot(s.error)) * s.normal;
    store(next_towards(s.position + offset, offset), &way.origins[i]);
}

/// See fresnel_dielectric().
HWY_INLINE Doubles dielectric(Doubles eta, Doubles cosine, Doubles refracted) {
    const Doubles ci = eta * cosine, ct = eta * refracted;
    const Doubles perpendicular = (ci - refracted) / (ci + refracted);
    const Doubles parallel = (cosine - ct) / (cosine + ct);
    return (perpendicular * perpendicular + parallel * parallel) / broadcast(2);
}

void make_leaving(LeavingRays::Chunk& c) {
    const DoubleTag tag;
    const Doubles zero = broadcast(0), one = broadcast(1);
    for (std::size_t i = 0; i < c.count; i += hn::Lanes(tag)) {
        const DoubleMask is_real = hn::FirstN(tag, c.count - i);
        const Doubles leave = hn::IfThenElseZero(is_real, hn::LoadU(tag, &c.leave[i]));
        if (hn::AllFalse(tag, leave > zero)) continue;
        const Vec3Lanes d = load(c.directions + i), n = load(c.normals + i);
        const DoubleMask in_front = hn::LoadU(tag, c.fronts + i) > zero;
        const Vec3Lanes near_normal = chosen(in_front, n, broadcast(-1) * n);
        const LeftSurfaces s{d, load(c.positions + i), load(c.errors + i), n, near_normal};
        const Vec3Lanes shading = load(c.shading_normals + i);
        const Vec3Lanes normal = chosen(d.dot(shading) < zero, shading, near_normal);
        const Doubles along = d.dot(normal), cosine = clamped_to_one(hn::Neg(along));
        store_way(s, normalized(d - (broadcast(2) * along) * normal), c.bias, i, c.mirrored);
        hn::StoreU(cosine, tag, &c.cosines[i]);
        if (hn::AllFalse(tag, leave > one)) continue;

        const Doubles eta = hn::LoadU(tag, &c.etas[i]);
        const Doubles sine2 = eta * eta * (one - cosine * cosine);
        const DoubleMask total = sine2 >= one;
        const Doubles refracted = hn::IfThenElse(total, zero, hn::Sqrt(one - sine2));
        hn::StoreU(hn::IfThenElse(total, one, dielectric(eta, cosine, refracted)), tag,
                   &c.reflectances[i]);
        hn::StoreU(hn::IfThenElse(total, one, zero), tag, &c.total[i]);
        store_way(s, normalized(eta * d + (eta * cosine - refracted) * normal), -c.bias, i,
                  c.refracted);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(make_leaving);

std::size_t LeavingRays::make(std::size_t first) {
    constexpr Color black(0.0F);
    first_ = first;
    Chunk& c = chunk_;
    c.count = std::min(most, surfaces_.size() - first);
    for (std::size_t i = 0; i < c.count; ++i) {
        const Material& m = *surfaces_.traits[first + i].material;
        c.leave[i] = m.transmission != black ? 2 : m.reflection != black ? 1 : 0;
        c.etas[i] = surfaces_.entering(first + i) ? 1 / m.ior : m.ior;
    }
    c.directions = &surfaces_.directions[first];
    c.positions = &surfaces_.positions[first];
    c.errors = &surfaces_.errors[first];
    c.normals = &surfaces_.normals[first];
    c.shading_normals = &surfaces_.shading_normals[first];
    c.fronts = &surfaces_.fronts[first];
    c.bias = rules_.fixed_bias;
    HWY_DYNAMIC_DISPATCH(make_leaving)(c);
    if (rules_.schlick) use_schlick();
    return c.count;
}

void LeavingRays::use_schlick() {
    for (std::size_t i = 0; i < chunk_.count; ++i) {
        if (chunk_.leave[i] < 2) continue;
        chunk_.reflectances[i] = fresnel_schlick(chunk_.etas[i], chunk_.cosines[i]).reflectance;
    }
}

Ray LeavingRays::ray(std::size_t i, const Way& way) const {
    Ray ray{way.origins[i], way.directions[i]};
    if (rules_.fixed_bias != 0) return ray;
    const SeenSurfaces::Traits& traits = surfaces_.traits[first_ + i];
    const bool outward = way.outwards[i] > 0;
    const bool for_good =
        traits.convexity == Convexity::flat || (traits.convexity == Convexity::convex && outward);
    if (for_good) ray.exclude = traits.primitive;
    return ray;
}

}  // namespace etalon
#endif
