#include "core/shading/shadow_rays.h"

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

/// Where the columns of ShadowRays begin.
struct ShadowColumns {
    MutableVec3Span origins, directions, towards;
    double *excludes, *cosines;
    std::int64_t* surfaces;
};

}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Returns how many rays there are.
std::size_t aim(const SeenSurfaces& from, const Vec3Buffer& lights, double fixed_bias,
                const ShadowColumns& to) {
    const DoubleTag tag;
    const Doubles zero = broadcast(0.0), one = broadcast(1.0), bias = broadcast(fixed_bias),
                  nothing = broadcast(no_index);
    std::size_t count = 0;
    for (std::size_t i = 0; i < from.size(); i += hn::Lanes(tag)) {
        const auto column = [&](const PaddedColumn<double>& values)
                                HWY_ATTR { return hn::LoadU(tag, &values[i]); };
        const Vec3Lanes position = load(from.positions.span(), i);
        const Vec3Lanes normal = load(from.normals.span(), i);
        const Vec3Lanes light = load(lights.span(), i), to_light = light - position;
        const Vec3Lanes towards = normalized(to_light);
        const Doubles cosine = load(from.shading_normals.span(), i).dot(towards);
        const Doubles facing = normal.dot(towards), leaving = normal.dot(to_light);
        const DoubleMask faces =
            hn::And(hn::And(cosine > zero, column(from.fronts) * facing > zero),
                    hn::And(column(from.scatters) > zero, hn::FirstN(tag, from.size() - i)));
        if (hn::AllFalse(tag, faces)) continue;

        const Doubles side = hn::IfThenElse(leaving < zero, hn::Neg(one), one);
        Doubles exclude = nothing;
        Vec3Lanes origin, direction;
        if (fixed_bias == 0) {
            const Doubles distance = abs(normal).dot(load(from.errors.span(), i));
            const Vec3Lanes offset = (side * distance) * normal;
            origin = next_towards(position + offset, offset);
            direction = light - origin;
            const DoubleMask leaves = side * normal.dot(direction) > zero;
            const Doubles left = hn::IfThenElse(leaving > zero, column(from.outward_excludes),
                                                column(from.inward_excludes));
            exclude = hn::IfThenElse(leaves, left, nothing);
        } else {
            const Doubles front = hn::IfThenElse(facing < zero, hn::Neg(bias), bias);
            origin = position + front * normal;
            direction = light - origin;
        }
        const ChosenLanes those(faces);
        those.store(origin, to.origins, count);
        those.store(direction, to.directions, count);
        those.store(towards, to.towards, count);
        those.store(exclude, to.excludes + count);
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

void ShadowRays::aim(const SeenSurfaces& from, const Vec3Buffer& lights, double fixed_bias) {
    rays_.make_room(from.size());
    towards.make_room(from.size());
    cosines.make_room(from.size());
    surfaces.make_room(from.size());
    count_ =
        HWY_DYNAMIC_DISPATCH(aim)(from, lights, fixed_bias,
                                  {rays_.origins.span(), rays_.directions.span(), towards.span(),
                                   rays_.excludes.data(), cosines.data(), surfaces.data()});
}

}  // namespace etalon
#endif
