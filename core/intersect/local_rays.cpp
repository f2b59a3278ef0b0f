#include "core/intersect/local_rays.h"

#include "core/intersect/ray_columns.h"

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/intersect/local_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/vec_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

using WordTag = hn::RebindToUnsigned<DoubleTag>;
using FloatTag = hn::Rebind<float, DoubleTag>;

HWY_INLINE Doubles max_abs(const Vec3Lanes& v) {
    return hn::Max(hn::Abs(v.x), hn::Max(hn::Abs(v.y), hn::Abs(v.z)));
}

/// Computes power_of_two_reciprocal() for x in [2^-1022, 2^1023).
HWY_INLINE Doubles power_of_two_reciprocal(Doubles x) {
    const auto field = hn::ShiftRight<52>(hn::BitCast(WordTag(), x));
    const auto mirrored = hn::Sub(hn::Set(WordTag(), 2 * 1023), field);
    return hn::BitCast(DoubleTag(), hn::ShiftLeft<52>(mirrored));
}

/// Returns whether rays miss the box or end before it, by a margin far above the roundings. False
/// for directions nearly parallel to one of its sides.
HWY_INLINE DoubleMask passes_by(const Vec3& reach, const Vec3Lanes& origin,
                                const Vec3Lanes& direction) {
    const Doubles one = broadcast(1), least = broadcast(0x1p-100);
    const Vec3Lanes size = abs(direction);
    const Doubles x = one / direction.x, y = one / direction.y, z = one / direction.z;
    const Vec3Lanes middle = {hn::Neg(origin.x * x), hn::Neg(origin.y * y), hn::Neg(origin.z * z)};
    const Vec3Lanes half = {hn::Abs(x) * broadcast(reach.x), hn::Abs(y) * broadcast(reach.y),
                            hn::Abs(z) * broadcast(reach.z)};
    const Vec3Lanes in = middle - half, out = middle + half;
    const Doubles last = hn::Min(out.x, hn::Min(out.y, out.z));
    const DoubleMask misses =
        hn::Or(hn::Max(in.x, hn::Max(in.y, in.z)) > last, last < hn::Zero(DoubleTag()));
    const Doubles smallest = hn::Min(size.x, hn::Min(size.y, size.z));
    return hn::And(misses, smallest > least);
}

HWY_INLINE void store_floats(const Vec3Lanes& v, Vec3f* to) {
    const FloatTag tag;
    hn::StoreInterleaved3(hn::DemoteTo(tag, v.x), hn::DemoteTo(tag, v.y), hn::DemoteTo(tag, v.z),
                          tag, &to->x);
}

/// Returns the rays that NormalizedSpace::resolves().
HWY_INLINE DoubleMask resolved(Doubles distance, Doubles speed) {
    constexpr double fastest = NormalizedSpace::largest_speed;
    return hn::And(distance < broadcast(NormalizedSpace::largest_distance),
                   hn::And(speed > broadcast(1 / fastest), speed < broadcast(fastest)));
}

HWY_INLINE void store_kinds(DoubleMask common, DoubleMask enters, std::uint64_t* to) {
    const DoubleTag tag;
    const auto number = [&](LocalRays::Kind kind) HWY_ATTR {
        return hn::Set(WordTag(), static_cast<std::uint64_t>(kind));
    };
    const auto words = [&](DoubleMask mask)
                           HWY_ATTR { return hn::BitCast(WordTag(), hn::VecFromMask(tag, mask)); };
    const auto bounded =
        hn::IfThenElse(hn::MaskFromVec(words(enters)), number(LocalRays::Kind::enters),
                       number(LocalRays::Kind::misses));
    hn::StoreU(hn::And(words(common), bounded), WordTag(), to);
}

/// Performs the steps of NormalizedSpace::ray().
void make_local(const NormalizedSpace& space, const RayColumns& c, LocalRayColumns to) {
    const DoubleTag tag;
    const Doubles scale = broadcast(space.scale());
    const Doubles largest_origin = broadcast(NormalizedSpace::largest_origin);
    const Vec3Lanes centre = broadcast(space.centre());
    const Vec3 reach = space.scale() * space.reach();
    for (std::size_t i = 0; i < c.count; i += hn::Lanes(tag)) {
        const Vec3Lanes along = load(c.directions, i);
        const Doubles largest = max_abs(along), shrink = power_of_two_reciprocal(largest);
        const Vec3Lanes direction = shrink * along;
        Vec3Lanes origin = scale * (load(c.origins, i) - centre);
        const Doubles distance = max_abs(origin);
        const auto is_common =
            hn::MaskFromVec(hn::BitCast(tag, hn::LoadU(WordTag(), &c.common[i])));

        Doubles shift = hn::Zero(tag);
        const DoubleMask is_far = distance > largest_origin;
        if (!hn::AllFalse(tag, is_far)) {
            const Doubles length2 = direction.dot(direction);
            const Doubles to_scene =
                hn::Neg(origin.dot(direction)) / length2 - broadcast(2) / hn::Sqrt(length2);
            shift = hn::IfThenElse(is_far, to_scene, shift);
            origin = origin + shift * direction;
        }
        const DoubleMask is_here = max_abs(origin) <= largest_origin;
        const DoubleMask enters = hn::AndNot(passes_by(reach, origin, direction), is_here);
        const Doubles time = scale / shrink;
        store_kinds(hn::And(is_common, resolved(distance, largest * scale)), enters, to.kinds + i);
        store_floats(origin, to.origins + i);
        store_floats(direction, to.directions + i);
        hn::StoreU(shift / time, tag, to.shifts + i);
        hn::StoreU(time, tag, to.scales + i);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(make_local);

void LocalRays::set(const NormalizedSpace& space, const RayColumns& rays) {
    dominants_ = rays.dominants;
    HWY_DYNAMIC_DISPATCH(make_local)
    (space, rays,
     {origins_.data(), directions_.data(), shifts_.data(), scales_.data(), kinds_.data()});
}

}  // namespace etalon
#endif
