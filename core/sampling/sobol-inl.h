// Points of the scrambled Sobol' sequence, several at a time. Included once for each instruction
// set.
#include <hwy/highway.h>

#include "core/sampling/sobol.h"

#if defined(ETALON_SOBOL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_SOBOL_INL
#undef ETALON_SOBOL_INL
#else
#define ETALON_SOBOL_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A vector of 32-bit words that can be used like a single one.
struct Words {
    using Tag = hn::CappedTag<std::uint32_t, sobol_lanes>;

    HWY_INLINE Words(hn::Vec<Tag> from) : words(from) {}
    HWY_INLINE Words(std::uint32_t word) : words(hn::Set(Tag(), word)) {}

    friend HWY_INLINE Words operator+(Words a, Words b) { return hn::Add(a.words, b.words); }
    friend HWY_INLINE Words operator*(Words a, Words b) { return hn::Mul(a.words, b.words); }
    friend HWY_INLINE Words operator^(Words a, Words b) { return hn::Xor(a.words, b.words); }
    friend HWY_INLINE Words operator|(Words a, Words b) { return hn::Or(a.words, b.words); }
    friend HWY_INLINE Words operator&(Words a, Words b) { return hn::And(a.words, b.words); }

    hn::Vec<Tag> words;
};

template <int count>
HWY_INLINE Words right(Words x) {
    return hn::ShiftRight<count>(x.words);
}
template <int count>
HWY_INLINE Words left(Words x) {
    return hn::ShiftLeft<count>(x.words);
}
template <int count>
std::uint32_t right(std::uint32_t x) {
    return x >> count;
}
template <int count>
std::uint32_t left(std::uint32_t x) {
    return x << count;
}

HWY_INLINE std::uint32_t reverse_bits(std::uint32_t x) {
    x = right<16>(x) | left<16>(x);
    x = left<8>(x & 0x00ff00ffU) | (right<8>(x) & 0x00ff00ffU);
    x = left<4>(x & 0x0f0f0f0fU) | (right<4>(x) & 0x0f0f0f0fU);
    x = left<2>(x & 0x33333333U) | (right<2>(x) & 0x33333333U);
    return left<1>(x & 0x55555555U) | (right<1>(x) & 0x55555555U);
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE Words reverse_bits(Words x) {
    return reverse_bits(hn::GetLane(x.words));
}

#else

/// Reverses the bytes, then the bits of each by looking up its halves: fewer steps, each of which
/// waits for the one before.
HWY_INLINE Words reverse_bits(Words x) {
    const hn::Repartition<std::uint8_t, Words::Tag> bytes;
    alignas(16) constexpr std::uint8_t order[] = {3,  2,  1, 0, 7,  6,  5,  4,
                                                  11, 10, 9, 8, 15, 14, 13, 12};
    alignas(16) constexpr std::uint8_t reversed[] = {0, 8, 4, 12, 2, 10, 6, 14,
                                                     1, 9, 5, 13, 3, 11, 7, 15};
    const auto table = hn::LoadDup128(bytes, reversed);
    const auto half = hn::Set(bytes, 15);
    const auto swapped =
        hn::TableLookupBytes(hn::BitCast(bytes, x.words), hn::LoadDup128(bytes, order));
    const auto upper = hn::BitCast(bytes, hn::ShiftRight<4>(hn::BitCast(Words::Tag(), swapped)));
    const auto low = hn::TableLookupBytes(table, hn::And(upper, half));
    const auto high = hn::TableLookupBytes(table, hn::And(swapped, half));
    return Words(hn::BitCast(Words::Tag(), low)) | left<4>(Words(hn::BitCast(Words::Tag(), high)));
}

#endif

/// Permutes x such that a bit is changed only by those below it (Laine & Karras 2011, "Stratified
/// Sampling for Stochastic Transparency"); constants after Vegdahl 2021, "Building a Better LK
/// Hash".
template <class Word>
HWY_INLINE Word low_to_high_permutation(Word x, Word seed) {
    x = x ^ x * 0x3d20adeaU;
    x = x + seed;
    x = x * (right<16>(seed) | 1U);
    x = x ^ x * 0x05526c56U;
    return x ^ x * 0x53a22864U;
}

/// Applies the second generator matrix of Sobol' with its rows reversed. The matrix is Pascal's
/// triangle modulo 2, in which C(k, j) is odd where all bits of j are bits of k (Lucas). So bit j
/// of the result is the sum of the bits k above it, computed in five steps, one for each bit of k.
template <class Word>
HWY_INLINE Word reversed_sobol_second(Word index) {
    index = index ^ (right<16>(index) & 0x0000ffffU);
    index = index ^ (right<8>(index) & 0x00ff00ffU);
    index = index ^ (right<4>(index) & 0x0f0f0f0fU);
    index = index ^ (right<2>(index) & 0x33333333U);
    return index ^ (right<1>(index) & 0x55555555U);
}

/// The coordinates of a point, in units of 2^-32.
template <class Word>
struct Coordinates {
    Word x, y;
};

/// Returns a point after a nested uniform scramble, in which the half to which an interval's points
/// go depends only on the interval. It is low_to_high_permutation between two reversals of bits.
/// The first reversal of each coordinate cancels the one with which the van der Corput sequence
/// begins, so neither is done.
template <class Word>
HWY_INLINE Coordinates<Word> scrambled_point(Word index, Word order, Word x, Word y) {
    const Word shuffled = reverse_bits(low_to_high_permutation(reverse_bits(index), order));
    return {reverse_bits(low_to_high_permutation(shuffled, x)),
            reverse_bits(low_to_high_permutation(reversed_sobol_second(shuffled), y))};
}

/// Converts coordinates to [0, 1). Only signed words can be converted, so half of the range is
/// subtracted before and added after, which is exact.
HWY_INLINE void store_unit_interval(const Coordinates<Words>& words, Vec2* points) {
    const Words::Tag tag;
    const hn::CappedTag<double, sobol_lanes / 2> doubles;
    const hn::Rebind<std::int32_t, decltype(doubles)> part;
    HWY_ALIGN std::int32_t x[sobol_lanes], y[sobol_lanes];
    const hn::RebindToSigned<Words::Tag> whole;
    hn::Store(hn::BitCast(whole, (words.x ^ 0x80000000U).words), whole, x);
    hn::Store(hn::BitCast(whole, (words.y ^ 0x80000000U).words), whole, y);
    const auto unit_interval = [&](const std::int32_t* from) HWY_ATTR {
        const auto lowered = hn::PromoteTo(doubles, hn::Load(part, from));
        return (lowered + hn::Set(doubles, 0x1p31)) * hn::Set(doubles, 0x1p-32);
    };
    for (std::size_t i = 0; i < hn::Lanes(tag); i += hn::Lanes(doubles)) {
        hn::StoreInterleaved2(unit_interval(x + i), unit_interval(y + i), doubles, &points[i].x);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
