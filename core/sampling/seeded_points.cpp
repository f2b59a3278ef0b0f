#include "core/sampling/seeded_points.h"

#define ETALON_WITH_AVX3
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sampling/seeded_points.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/sampling/sobol-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE Words hashed(Words seeds, std::uint32_t b) {
    return hash(hn::GetLane(seeds.words), b);
}

#else

using WideTag = hn::Repartition<std::uint64_t, Words::Tag>;
using Wide = hn::Vec<WideTag>;

/// Returns the lower halves of products, of which not every instruction set has an instruction.
HWY_INLINE Wide times(Wide x, std::uint64_t factor) {
    const WideTag tag;
    const hn::Repartition<std::uint32_t, WideTag> halves;
    const auto low = hn::Set(tag, factor & 0xffffffffU), high = hn::Set(tag, factor >> 32);
    const auto product = [&](Wide a, Wide b) HWY_ATTR {
        return hn::MulEven(hn::BitCast(halves, a), hn::BitCast(halves, b));
    };
    return hn::Add(product(x, low), hn::ShiftLeft<32>(hn::Add(product(hn::ShiftRight<32>(x), low),
                                                              product(x, high))));
}

/// Computes hash(a, b) in 64-bit lanes that hold `a` in their upper halves and zeros below.
HWY_INLINE Wide hash_upper(Wide a, std::uint32_t b) {
    const auto folded = [](Wide x) HWY_ATTR { return hn::Xor(x, hn::ShiftRight<33>(x)); };
    Wide h = hn::Add(a, hn::Set(WideTag(), 0x9e3779b97f4a7c15U + b));
    h = times(folded(h), 0xff51afd7ed558ccdU);
    return folded(times(folded(h), 0xc4ceb9fe1a85ec53U));
}

/// Computes hash(a, b) for each a.
HWY_INLINE Words hashed(Words seeds, std::uint32_t b) {
    const WideTag tag;
    const Wide both = hn::BitCast(tag, seeds.words), low = hn::Set(tag, 0xffffffffU);
    const Wide even = hash_upper(hn::ShiftLeft<32>(both), b);
    const Wide odd = hash_upper(hn::AndNot(low, both), b);
    return hn::BitCast(Words::Tag(), hn::Or(hn::And(even, low), hn::ShiftLeft<32>(odd)));
}

#endif

/// Makes the points, padding included, by the steps of ScrambledSobol.
void make_points(const PointNames& names, Vec2* points) {
    const Words::Tag tag;
    for (std::size_t i = 0; i < names.size(); i += hn::Lanes(tag)) {
        const Words seed(hn::LoadU(tag, names.seeds() + i));
        const Words index(hn::LoadU(tag, names.indices() + i));
        store_unit_interval(
            scrambled_point(index, hashed(seed, 0), hashed(seed, 1), hashed(seed, 2)), points + i);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(make_points);

std::span<const Vec2> SeededPoints::make(Sampler sampler) {
    if (points_.size() < names_.padded_size()) points_.resize(2 * names_.padded_size());
    if (sampler == Sampler::sobol) {
        HWY_DYNAMIC_DISPATCH(make_points)(names_, points_.data());
    } else {
        for (std::size_t i = 0; i < names_.size(); ++i) {
            points_[i] = uniform_random(names_.indices()[i], names_.seeds()[i]);
        }
    }
    return std::span<const Vec2>(points_).first(names_.size());
}

}  // namespace etalon
#endif
