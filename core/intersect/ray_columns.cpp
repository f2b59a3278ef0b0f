#include "core/intersect/ray_columns.h"

#include "core/intersect/rescaled_ray.h"

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/intersect/ray_columns.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/vec_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

using WordTag = hn::RebindToUnsigned<DoubleTag>;

HWY_INLINE DoubleMask is_finite(const Vec3Lanes& v) {
    const Doubles end = broadcast(infinity);
    return hn::And(hn::Abs(v.x) < end, hn::And(hn::Abs(v.y) < end, hn::Abs(v.z) < end));
}

HWY_INLINE DoubleMask is_zero_or_above(Doubles least, Doubles size) {
    return hn::Or(size >= least, size == hn::Zero(DoubleTag()));
}

/// Classifies rays by the conditions of is_valid() and RayQuery.
HWY_INLINE DoubleMask common(const RayColumns& c, std::size_t i, const Vec3Lanes& size) {
    const DoubleTag tag;
    const Doubles largest = hn::Max(size.x, hn::Max(size.y, size.z));
    const Doubles least = broadcast(0x1p-500) * largest;
    const DoubleMask in_range = hn::And(largest >= broadcast(1 / largest_usual_direction),
                                        largest <= broadcast(largest_usual_direction));
    const DoubleMask not_negligible =
        hn::And(is_zero_or_above(least, size.x),
                hn::And(is_zero_or_above(least, size.y), is_zero_or_above(least, size.z)));
    const DoubleMask is_way = hn::LoadU(tag, &c.tmins[i]) < hn::LoadU(tag, &c.tmaxs[i]);
    // What is not finite is not in range or, if it is no number, negligible.
    return hn::And(is_finite(load(c.origins, i)),
                   hn::And(is_way, hn::And(in_range, not_negligible)));
}

using Words = hn::Vec<WordTag>;

/// Returns dominant_axis() of several rays.
HWY_INLINE Words dominant(const Vec3Lanes& size) {
    const WordTag tag;
    const auto words = [](DoubleMask mask) HWY_ATTR {
        return hn::BitCast(WordTag(), hn::VecFromMask(DoubleTag(), mask));
    };
    const auto is_x = words(hn::And(size.x >= size.y, size.x >= size.z));
    const auto y_or_z = hn::Add(hn::Set(tag, 2), words(size.y >= size.z));  // a mask is -1
    return hn::AndNot(is_x, y_or_z);
}

void describe(RayColumns& c) {
    const DoubleTag tag;
    const WordTag words;
    const Words first = hn::Set(words, dominant_axis(c.directions[0]));
    DoubleMask are_alike = hn::FirstN(tag, most_doubles);
    for (std::size_t i = 0; i < c.count; i += hn::Lanes(tag)) {
        const Vec3Lanes size = abs(load(c.directions, i));
        const DoubleMask is_common = common(c, i, size);
        const Words axis = dominant(size);
        hn::StoreU(hn::BitCast(words, hn::VecFromMask(tag, is_common)), words, &c.common[i]);
        hn::StoreU(axis, words, &c.dominants[i]);
        const DoubleMask is_along = hn::RebindMask(tag, axis == first);
        const DoubleMask is_beyond = hn::Not(hn::FirstN(tag, c.count - i));
        are_alike = hn::And(are_alike, hn::Or(is_beyond, hn::And(is_common, is_along)));
    }
    c.are_alike = hn::AllTrue(tag, are_alike);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(describe);

/// The lanes beyond the last ray repeat it, so that a branch on all lanes depends on rays only.
RayColumns::RayColumns(std::span<const Ray> rays) : count(rays.size()) {
    static_assert(most % padded_doubles == 0);
    origins = own_origins_.span();
    directions = own_directions_.span();
    const auto set = [&](std::size_t i, const Ray& ray) {
        own_origins_.set(i, ray.origin);
        own_directions_.set(i, ray.direction);
        tmins[i] = ray.tmin;
        tmaxs[i] = ray.tmax;
    };
    for (std::size_t i = 0; i < count; ++i) set(i, rays[i]);
    for (std::size_t i = count; i % padded_doubles != 0; ++i) set(i, rays.back());
    HWY_DYNAMIC_DISPATCH(describe)(*this);
}

RayColumns::RayColumns(const RayStream& rays)
    : count(rays.size()), origins(rays.origins), directions(rays.directions) {
    tmins.fill(0);
    tmaxs.fill(rays.tmax);
    HWY_DYNAMIC_DISPATCH(describe)(*this);
}

}  // namespace etalon
#endif
