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

/// As many surfaces of a chunk as vectors have lanes.
struct LeftSurfaces {
    Vec3Lanes direction, position, error, normal, near_normal;
    Doubles outward_exclude, inward_exclude;
};

HWY_INLINE Vec3Lanes chosen(DoubleMask mask, const Vec3Lanes& yes, const Vec3Lanes& no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
            hn::IfThenElse(mask, yes.z, no.z)};
}

HWY_INLINE Doubles clamped_to_one(Doubles x) {
    const Doubles zero = broadcast(0), one = broadcast(1);
    return hn::IfThenElse(x < zero, zero, hn::IfThenElse(one < x, one, x));
}

/// Spawns rays by the steps of spawn_ray(), or with a fixed bias, and stores them.
HWY_INLINE void store_rays(const LeftSurfaces& s, const Vec3Lanes& direction, double bias,
                           std::size_t i, LeavingRays::SpawnedRays& rays) {
    const DoubleTag tag;
    const Doubles zero = broadcast(0), one = broadcast(1);
    store(direction, rays.directions.span(), i);
    if (bias != 0) {
        store(s.position + broadcast(bias) * s.near_normal, rays.origins.span(), i);
        hn::StoreU(broadcast(no_index), tag, &rays.excludes[i]);
        return;
    }
    const Doubles outward = s.normal.dot(direction);
    const Doubles side = hn::IfThenElse(outward < zero, hn::Neg(one), one);
    const Vec3Lanes offset = (side * abs(s.normal).dot(s.error)) * s.normal;
    store(next_towards(s.position + offset, offset), rays.origins.span(), i);
    hn::StoreU(hn::IfThenElse(outward > zero, s.outward_exclude, s.inward_exclude), tag,
               &rays.excludes[i]);
}

/// Computes fresnel_dielectric().reflectance with the same operations.
HWY_INLINE Doubles dielectric(Doubles eta, Doubles cosine, Doubles refracted) {
    const Doubles ci = eta * cosine, ct = eta * refracted;
    const Doubles perpendicular = (ci - refracted) / (ci + refracted);
    const Doubles parallel = (cosine - ct) / (cosine + ct);
    return (perpendicular * perpendicular + parallel * parallel) / broadcast(2);
}

void make_leaving(const SeenSurfaces& from, double bias, LeavingRays::Chunk& c) {
    const DoubleTag tag;
    const Doubles zero = broadcast(0), one = broadcast(1);
    for (std::size_t i = 0; i < c.count; i += hn::Lanes(tag)) {
        const std::size_t number = c.first + i;
        const auto column = [&](const PaddedColumn<double>& values)
                                HWY_ATTR { return hn::LoadU(tag, &values[number]); };
        const Doubles leave =
            hn::IfThenElseZero(hn::FirstN(tag, c.count - i), column(from.sends_on));
        if (hn::AllFalse(tag, leave > zero)) continue;
        const Vec3Lanes d = load(from.directions.span(), number);
        const Vec3Lanes n = load(from.normals.span(), number);
        const Vec3Lanes near_normal = chosen(column(from.fronts) > zero, n, broadcast(-1) * n);
        const LeftSurfaces s{
            d,           load(from.positions.span(), number), load(from.errors.span(), number), n,
            near_normal, column(from.outward_excludes),       column(from.inward_excludes)};
        const Vec3Lanes shading = load(from.shading_normals.span(), number);
        const Vec3Lanes normal = chosen(d.dot(shading) < zero, shading, near_normal);
        const Doubles along = d.dot(normal), cosine = clamped_to_one(hn::Neg(along));
        store_rays(s, normalized(d - (broadcast(2) * along) * normal), bias, i, c.mirrored);
        hn::StoreU(cosine, tag, &c.cosines[i]);
        if (hn::AllFalse(tag, leave > one)) continue;

        const Doubles eta = hn::LoadU(tag, &c.etas[i]);
        const Doubles sine2 = eta * eta * (one - cosine * cosine);
        const DoubleMask total = sine2 >= one;
        const Doubles refracted = hn::IfThenElse(total, zero, hn::Sqrt(one - sine2));
        hn::StoreU(hn::IfThenElse(total, one, dielectric(eta, cosine, refracted)), tag,
                   &c.reflectances[i]);
        hn::StoreU(hn::IfThenElse(total, one, zero), tag, &c.total[i]);
        store_rays(s, normalized(eta * d + (eta * cosine - refracted) * normal), -bias, i,
                   c.refracted);
    }
}

void put(const LeavingRays::SpawnedRays& rays, LeavingRays::Choice choice, RayBuffer& to,
         std::size_t at) {
    const DoubleTag tag;
    for (std::size_t i = 0; choice != 0; i += hn::Lanes(tag), choice >>= hn::Lanes(tag)) {
        const ChosenLanes those(
            hn::LoadMaskBits(tag, reinterpret_cast<const std::uint8_t*>(&choice)));
        those.store(load(rays.origins.span(), i), to.origins.span(), at);
        those.store(load(rays.directions.span(), i), to.directions.span(), at);
        those.store(hn::LoadU(tag, &rays.excludes[i]), &to.excludes[at]);
        at += those.count();
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(make_leaving);
HWY_EXPORT(put);

std::size_t LeavingRays::make(std::size_t first) {
    Chunk& c = chunk_;
    c.first = first;
    c.count = std::min(most, surfaces_.size() - first);
    c.leave = 0;
    for (std::size_t i = 0; i < c.count; ++i) {
        if (!(surfaces_.sends_on[first + i] > 0)) continue;
        c.leave |= Choice{1} << i;
        const double ior = surfaces_.traits[first + i].material->ior;
        c.etas[i] = surfaces_.entering(first + i) ? 1 / ior : ior;
    }
    if (c.leave == 0) return c.count;
    HWY_DYNAMIC_DISPATCH(make_leaving)(surfaces_, rules_.fixed_bias, c);
    if (rules_.schlick) use_schlick();
    return c.count;
}

void LeavingRays::use_schlick() {
    for (std::size_t i = 0; i < chunk_.count; ++i) {
        if (!surfaces_.is_glass(chunk_.first + i)) continue;
        chunk_.reflectances[i] = fresnel_schlick(chunk_.etas[i], chunk_.cosines[i]).reflectance;
    }
}

void LeavingRays::put_mirrored(Choice choice, RayBuffer& to, std::size_t at) const {
    HWY_DYNAMIC_DISPATCH(put)(chunk_.mirrored, choice, to, at);
}

void LeavingRays::put_refracted(Choice choice, RayBuffer& to, std::size_t at) const {
    HWY_DYNAMIC_DISPATCH(put)(chunk_.refracted, choice, to, at);
}

}  // namespace etalon
#endif
