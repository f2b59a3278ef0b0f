#include "core/shading/shadow_rays.h"

#include <algorithm>

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/shading/shadow_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/vec_lanes-inl.h"

#ifndef ETALON_SHADOW_RAYS_ONCE
#define ETALON_SHADOW_RAYS_ONCE
namespace etalon {

/// Pointers to the columns of ShadowRays.
struct ShadowColumns {
    MutableVec3Span origins, directions, towards;
    double *excludes, *cosines;
    std::int64_t* surfaces;
};

}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

HWY_INLINE Doubles column(const PaddedColumn<double>& values, std::size_t i) {
    return hn::LoadU(DoubleTag(), &values[i]);
}

/// Rays from surfaces to points of a light.
struct AimedRays {
    Vec3Lanes origin, direction;
    Doubles exclude;
};

/// Computes rays by the steps of spawn_ray_to(), for surfaces from number i on.
HWY_INLINE AimedRays aimed(const SeenSurfaces& from, std::size_t i, const Vec3Lanes& light) {
    const Doubles zero = broadcast(0.0), one = broadcast(1.0);
    const Vec3Lanes position = load(from.positions.span(), i);
    const Vec3Lanes normal = load(from.normals.span(), i);
    const Doubles leaving = normal.dot(light - position);
    const Doubles side = hn::IfThenElse(leaving < zero, hn::Neg(one), one);
    const Doubles distance = abs(normal).dot(load(from.errors.span(), i));
    const Vec3Lanes offset = (side * distance) * normal;
    const Vec3Lanes origin = next_towards(position + offset, offset), direction = light - origin;
    const DoubleMask moves_away = side * normal.dot(direction) > zero;
    const Doubles left = hn::IfThenElse(leaving > zero, column(from.outward_excludes, i),
                                        column(from.inward_excludes, i));
    return {origin, direction, hn::IfThenElse(moves_away, left, broadcast(no_index))};
}

/// The same for rays that begin at distance `fixed_bias` from the surface; `facing` is normal .
/// direction.
HWY_INLINE AimedRays aimed(const SeenSurfaces& from, std::size_t i, const Vec3Lanes& light,
                           Doubles facing, double fixed_bias) {
    const Doubles bias = broadcast(fixed_bias);
    const Doubles front = hn::IfThenElse(facing < broadcast(0.0), hn::Neg(bias), bias);
    const Vec3Lanes origin = load(from.positions.span(), i) + front * load(from.normals.span(), i);
    return {origin, light - origin, broadcast(no_index)};
}

/// Returns true if none of the surfaces from number i on scatters and faces its light, which is at
/// `to_light` from it. That the rounded unit vector to the light has the same sign follows where
/// the dot product exceeds the errors of both, below 2^-48 of the length for normals up to twice
/// too long, and where neither it nor the squared length underflows. Then no vector is normalized.
HWY_INLINE bool none_faces(const SeenSurfaces& from, std::size_t i, const Vec3Lanes& to_light) {
    const Vec3Lanes size = abs(to_light);
    const Doubles margin =
        hn::Max(broadcast(0x1p-46) * (size.x + size.y + size.z), broadcast(0x1p-480));
    const Doubles facing = load(from.normals.span(), i).dot(to_light);
    const DoubleMask faces_away =
        hn::Or(load(from.shading_normals.span(), i).dot(to_light) < hn::Neg(margin),
               column(from.fronts, i) * facing < hn::Neg(margin));
    return hn::AllTrue(DoubleTag(), hn::Or(faces_away, column(from.scatters, i) <= broadcast(0.0)));
}

/// Computes all rays. Returns their number.
std::size_t aim(const SeenSurfaces& from, const LightPoints& lights, double fixed_bias,
                const ShadowColumns& to) {
    const DoubleTag tag;
    const Doubles zero = broadcast(0.0);
    const Vec3Lanes one = broadcast(lights.one);
    std::size_t count = 0;
    for (std::size_t i = 0; i < from.size(); i += hn::Lanes(tag)) {
        const Vec3Lanes light = lights.is_one ? one : load(lights.each.span(), i);
        const Vec3Lanes to_light = light - load(from.positions.span(), i);
        if (none_faces(from, i, to_light)) continue;
        const Vec3Lanes towards = normalized(to_light);
        const Doubles cosine = load(from.shading_normals.span(), i).dot(towards);
        const Doubles facing = load(from.normals.span(), i).dot(towards);
        const DoubleMask faces =
            hn::And(hn::And(cosine > zero, column(from.fronts, i) * facing > zero),
                    hn::And(column(from.scatters, i) > zero, hn::FirstN(tag, from.size() - i)));
        if (hn::AllFalse(tag, faces)) continue;

        const AimedRays rays =
            fixed_bias == 0 ? aimed(from, i, light) : aimed(from, i, light, facing, fixed_bias);
        const ChosenLanes those(faces);
        those.store(rays.origin, to.origins, count);
        those.store(rays.direction, to.directions, count);
        those.store(towards, to.towards, count);
        those.store(rays.exclude, to.excludes + count);
        those.store(cosine, to.cosines + count);
        those.store_numbers(i, to.surfaces + count);
        count += those.count();
    }
    return count;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(aim);

void ShadowRays::aim(const SeenSurfaces& from, const LightPoints& lights, double fixed_bias) {
    rays_.make_room(from.size());
    towards.make_room(from.size());
    cosines.make_room(from.size());
    surfaces.make_room(from.size());
    count_ =
        HWY_DYNAMIC_DISPATCH(aim)(from, lights, fixed_bias,
                                  {rays_.origins.span(), rays_.directions.span(), towards.span(),
                                   rays_.excludes.data(), cosines.data(), surfaces.data()});
    blocked.assign(count_, 0);
}

std::size_t ShadowRays::first_from(std::size_t surface) const {
    const std::int64_t* const first = surfaces.data();
    return std::lower_bound(first, first + count_, static_cast<std::int64_t>(surface)) - first;
}

}  // namespace etalon
#endif
