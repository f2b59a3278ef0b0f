// Vectors of doubles with as many lanes as an instruction takes, and operators like those of single
// numbers. Sums are in the order of Vec3, so that each lane has the bits of the same formula for a
// Vec3. Compiled for each instruction set.
#if defined(ETALON_VEC_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_VEC_LANES_INL_H
#undef ETALON_VEC_LANES_INL_H
#else
#define ETALON_VEC_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <array>
#include <cstdint>

#include "core/numerics/vec_columns.h"

#ifndef ETALON_VEC_LANES_ONCE
#define ETALON_VEC_LANES_ONCE
namespace etalon {

/// The numbers of the bits that are set in each byte, the lowest first, followed by zeros.
inline constexpr auto set_bits = [] {
    std::array<std::array<std::int64_t, 8>, 256> numbers{};
    for (unsigned byte = 0; byte < 256; ++byte) {
        std::size_t count = 0;
        for (std::int64_t bit = 0; bit < 8; ++bit) {
            if ((byte >> bit & 1) != 0) numbers[byte][count++] = bit;
        }
    }
    return numbers;
}();

}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Largest number of lanes of this instruction set.
#if HWY_TARGET == HWY_AVX3
inline constexpr std::size_t most_doubles = 8;
#else
inline constexpr std::size_t most_doubles = 4;
#endif

using DoubleTag = hn::CappedTag<double, most_doubles>;
using Doubles = hn::Vec<DoubleTag>;
using DoubleMask = hn::Mask<DoubleTag>;
static_assert(most_doubles <= padded_doubles);

HWY_INLINE Doubles broadcast(double x) {
    return hn::Set(DoubleTag(), x);
}

struct Vec2Lanes {
    Doubles x, y;
};

struct Vec3Lanes {
    Doubles x, y, z;

    HWY_INLINE Doubles dot(const Vec3Lanes& v) const { return x * v.x + y * v.y + z * v.z; }
    HWY_INLINE Vec3Lanes cross(const Vec3Lanes& v) const {
        return {y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x};
    }

    friend HWY_INLINE Vec3Lanes operator+(const Vec3Lanes& a, const Vec3Lanes& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend HWY_INLINE Vec3Lanes operator-(const Vec3Lanes& a, const Vec3Lanes& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend HWY_INLINE Vec3Lanes operator*(Doubles s, const Vec3Lanes& v) {
        return {s * v.x, s * v.y, s * v.z};
    }
    friend HWY_INLINE Vec3Lanes operator/(const Vec3Lanes& v, Doubles s) {
        return {v.x / s, v.y / s, v.z / s};
    }
};

HWY_INLINE Vec3Lanes broadcast(const Vec3& v) {
    return {broadcast(v.x), broadcast(v.y), broadcast(v.z)};
}

/// Loads the vectors that begin at `from`.
HWY_INLINE Vec2Lanes load(const Vec2* from) {
    Vec2Lanes v;
    hn::LoadInterleaved2(DoubleTag(), &from->x, v.x, v.y);
    return v;
}
HWY_INLINE Vec3Lanes load(const Vec3* from) {
    Vec3Lanes v;
    hn::LoadInterleaved3(DoubleTag(), &from->x, v.x, v.y, v.z);
    return v;
}
HWY_INLINE Vec3Lanes load(const Vec3Span& from, std::size_t first) {
    const DoubleTag tag;
    return {hn::LoadU(tag, from.x + first), hn::LoadU(tag, from.y + first),
            hn::LoadU(tag, from.z + first)};
}
HWY_INLINE void store(const Vec3Lanes& v, const MutableVec3Span& to, std::size_t first) {
    const DoubleTag tag;
    hn::StoreU(v.x, tag, to.x + first);
    hn::StoreU(v.y, tag, to.y + first);
    hn::StoreU(v.z, tag, to.z + first);
}

/// Stores selected lanes of several columns compactly. The order of the lanes is computed once for
/// all columns. A whole vector is written.
class ChosenLanes {
  public:
    HWY_INLINE explicit ChosenLanes(DoubleMask mask)
        : ChosenLanes(bits_of(mask), hn::CountTrue(DoubleTag(), mask)) {}

    HWY_INLINE std::size_t count() const { return count_; }

    HWY_INLINE void store(Doubles v, double* to) const {
        hn::StoreU(hn::TableLookupLanes(v, order_), DoubleTag(), to);
    }
    HWY_INLINE void store(const Vec3Lanes& v, const MutableVec3Span& to, std::size_t first) const {
        store(v.x, to.x + first);
        store(v.y, to.y + first);
        store(v.z, to.z + first);
    }

    /// Stores the numbers of the selected lanes, counted from `first_number` for the first lane.
    HWY_INLINE void store_numbers(std::size_t first_number, std::int64_t* to) const {
        const hn::RebindToSigned<DoubleTag> tag;
        const auto lanes = hn::LoadU(tag, set_bits[bits_].data());
        hn::StoreU(hn::Add(lanes, hn::Set(tag, static_cast<std::int64_t>(first_number))), tag, to);
    }

  private:
    HWY_INLINE ChosenLanes(std::uint8_t bits, std::size_t count)
        : bits_(bits),
          count_(count),
          order_(hn::SetTableIndices(DoubleTag(), set_bits[bits].data())) {}

    HWY_INLINE static std::uint8_t bits_of(DoubleMask mask) {
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(DoubleTag(), mask, bytes);
        return bytes[0];
    }

    std::uint8_t bits_;
    std::size_t count_;
    decltype(hn::SetTableIndices(DoubleTag(), set_bits[0].data())) order_;
};

HWY_INLINE void store(const Vec3Lanes& v, Vec3* to) {
    hn::StoreInterleaved3(v.x, v.y, v.z, DoubleTag(), &to->x);
}

HWY_INLINE Vec3Lanes abs(const Vec3Lanes& v) {
    return {hn::Abs(v.x), hn::Abs(v.y), hn::Abs(v.z)};
}

HWY_INLINE Vec3Lanes normalized(const Vec3Lanes& v) {
    return v / hn::Sqrt(v.dot(v));
}

/// Computes next_towards() of core/numerics/rounding.h; x itself where `direction` is zero.
HWY_INLINE Doubles next_towards(Doubles x, Doubles direction) {
    using Bits = hn::RebindToSigned<DoubleTag>;
    const Doubles zero = hn::Zero(DoubleTag());
    const auto bits = hn::BitCast(Bits(), x), turn = hn::BitCast(Bits(), hn::Xor(x, direction));
    const auto step = hn::Or(hn::BroadcastSignBit(turn), hn::Set(Bits(), 1));
    const Doubles least = broadcast(std::numeric_limits<double>::denorm_min());
    const Doubles next = hn::IfThenElse(x == zero, hn::CopySign(least, direction),
                                        hn::BitCast(DoubleTag(), hn::Add(bits, step)));
    const DoubleMask moves = hn::And(hn::Abs(x) < broadcast(infinity), direction != zero);
    return hn::IfThenElse(moves, next, x);
}

HWY_INLINE Vec3Lanes next_towards(const Vec3Lanes& v, const Vec3Lanes& direction) {
    return {next_towards(v.x, direction.x), next_towards(v.y, direction.y),
            next_towards(v.z, direction.z)};
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
