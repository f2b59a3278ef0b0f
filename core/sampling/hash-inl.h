// hash() of several words at a time. Included once for each instruction set.
#include "core/sampling/sobol-inl.h"

#if defined(ETALON_HASH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_HASH_INL
#undef ETALON_HASH_INL
#else
#define ETALON_HASH_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE Words hashed(Words a, Words b) {
    return hash(hn::GetLane(a.words), hn::GetLane(b.words));
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

/// Computes hash(a, b) in 64-bit lanes that hold `a` in their upper halves and `b` below.
HWY_INLINE Wide hashed(Wide both) {
    const auto folded = [](Wide x) HWY_ATTR { return hn::Xor(x, hn::ShiftRight<33>(x)); };
    Wide h = hn::Add(both, hn::Set(WideTag(), 0x9e3779b97f4a7c15U));
    h = times(folded(h), 0xff51afd7ed558ccdU);
    return folded(times(folded(h), 0xc4ceb9fe1a85ec53U));
}

/// Computes hash(a, b) for each pair.
HWY_INLINE Words hashed(Words a, Words b) {
    const WideTag tag;
    const Wide upper = hn::BitCast(tag, a.words), lower = hn::BitCast(tag, b.words);
    const Wide low = hn::Set(tag, 0xffffffffU);
    const Wide even = hashed(hn::Or(hn::ShiftLeft<32>(upper), hn::And(lower, low)));
    const Wide odd = hashed(hn::Or(hn::AndNot(low, upper), hn::ShiftRight<32>(lower)));
    return hn::BitCast(Words::Tag(), hn::Or(hn::And(even, low), hn::ShiftLeft<32>(odd)));
}

#endif

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
