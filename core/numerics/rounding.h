// Directed rounding, and the unit roundoffs that every error bound is written in.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/numerics/vec.h"

namespace etalon {

/// Unit roundoff: the largest relative error of one correctly rounded operation.
inline constexpr double unit_roundoff = 0x1p-53;
inline constexpr float unit_roundoff_f = 0x1p-24F;

/// Bound on the relative error of n rounded operations in sequence (Higham 2002, lemma 3.1).
constexpr double gamma(int n) {
    return n * unit_roundoff / (1 - n * unit_roundoff);
}

/// The largest float <= x; x may be infinite.
inline float float_down(double x) {
    const float f = static_cast<float>(x);
    return f > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}

/// The smallest float >= x; x may be infinite.
inline float float_up(double x) {
    const float f = static_cast<float>(x);
    return f < x ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

inline Vec3f float_down(const Vec3& v) {
    return {float_down(v.x), float_down(v.y), float_down(v.z)};
}
inline Vec3f float_up(const Vec3& v) {
    return {float_up(v.x), float_up(v.y), float_up(v.z)};
}

/// The smallest float box that contains `box`.
inline Box3f round_outward(const Box3& box) {
    return {float_down(box.min), float_up(box.max)};
}

/// The power of two 2^-e with 2^e <= x < 2^(e+1): multiplying by it is exact and brings x to [1,
/// 2). The largest there is, 2^1023, where that would be infinite; 1 for zero, infinities and NaN.
inline double power_of_two_reciprocal(double x) {
    if (!(x > 0) || !std::isfinite(x)) return 1;
    return std::ldexp(1.0, std::min(-std::ilogb(x), 1023));
}

}  // namespace etalon
