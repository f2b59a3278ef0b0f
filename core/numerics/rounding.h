// Directed rounding, and the unit roundoffs in which all error bounds are expressed.
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

/// Returns a bound on the relative error of n rounded operations in sequence (Higham 2002, lemma
/// 3.1).
constexpr double gamma(int n) {
    return n * unit_roundoff / (1 - n * unit_roundoff);
}

/// Returns the neighbour of a double on the side to which `direction`, which is not zero, points;
/// infinities and NaN are returned as they are. The same as std::nextafter(), which is a library
/// call.
inline double next_towards(double x, double direction) {
    if (x == 0) return std::copysign(std::numeric_limits<double>::denorm_min(), direction);
    if (!std::isfinite(x)) return x;
    const auto bits = std::bit_cast<std::int64_t>(x);
    return std::bit_cast<double>(bits + ((x > 0) == (direction > 0) ? 1 : -1));
}

/// Maps the bits of a float to its place among all floats, with -0 just below 0, and back.
inline std::int32_t in_order(std::int32_t bits) {
    return bits ^ ((bits >> 31) & std::numeric_limits<std::int32_t>::max());
}

/// Returns `x` moved by `by` floats. The two zeros count separately.
inline float moved(float x, int by) {
    return std::bit_cast<float>(in_order(in_order(std::bit_cast<std::int32_t>(x)) + by));
}

/// Returns the largest float <= x; x may be infinite. Without a branch on the direction in which x
/// was rounded, which is not predictable. A zero is not moved to the other one: negative numbers
/// round to -0.
inline float float_down(double x) {
    const auto f = static_cast<float>(x);
    return moved(f, f > x ? -1 : 0);
}

/// Returns the smallest float >= x; x may be infinite.
inline float float_up(double x) {
    const auto f = static_cast<float>(x);
    return moved(f, f < x ? 1 : 0);
}

inline Vec3f float_down(const Vec3& v) {
    return {float_down(v.x), float_down(v.y), float_down(v.z)};
}
inline Vec3f float_up(const Vec3& v) {
    return {float_up(v.x), float_up(v.y), float_up(v.z)};
}

/// Returns the smallest float box that contains `box`.
inline Box3f round_outward(const Box3& box) {
    return {float_down(box.min), float_up(box.max)};
}

/// Returns the power of two 2^-e with 2^e <= x < 2^(e+1): multiplying by it is exact and brings x
/// to [1, 2). Returns 2^1023 where the result would be infinite; 1 for zero, infinities and NaN.
inline double power_of_two_reciprocal(double x) {
    // The exponent field of x is e + 1023, that of the result 1023 - e. The C library's functions
    // for this cost as much as the rest of a ray's set-up.
    constexpr std::uint64_t one = 1023, largest = 2046, exponent = 52;
    const std::uint64_t field = std::bit_cast<std::uint64_t>(x) >> exponent;
    if (field > 0 && field < largest) return std::bit_cast<double>((2 * one - field) << exponent);
    if (!(x > 0) || !std::isfinite(x)) return 1;
    return std::ldexp(1.0, std::min(-std::ilogb(x), 1023));
}

/// Returns `v` times the power of two that puts its largest component in [1, 2), so that no square
/// leaves the range of double. Zero stays zero.
inline Vec3 to_unit_magnitude(const Vec3& v) {
    return v * power_of_two_reciprocal(max_abs(v));
}

/// Returns `v` divided by its length, whose square may be out of range; `v` must not be zero.
inline Vec3 unit_vector(const Vec3& v) {
    return normalized(to_unit_magnitude(v));
}

}  // namespace etalon
