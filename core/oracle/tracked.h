// Numbers with error bounds, and decisions that may be "unknown".
#pragma once

#include <algorithm>

#include "core/numerics/vec.h"
#include "core/oracle/quad.h"

namespace etalon {

/// Ordered such that `and` is the least and `or` the greatest of the operands.
enum class Certainty { no, unknown, yes };

inline Certainty certainty(bool b) {
    return b ? Certainty::yes : Certainty::no;
}
inline Certainty operator&(Certainty a, Certainty b) {
    return std::min(a, b);
}
inline Certainty operator|(Certainty a, Certainty b) {
    return std::max(a, b);
}
inline Certainty operator!(Certainty a) {
    return a == Certainty::unknown ? a : certainty(a == Certainty::no);
}

/// A value computed in quad precision with a bound on its error (running error analysis, Higham
/// 2002, section 3.3). Doubles are exact, and an operation whose result is exact adds nothing. So a
/// quantity that is zero by the input's structure, such as the distance from an edge aimed at
/// exactly, is *known* to be zero.
struct Tracked {
    Tracked() = default;
    Tracked(double x) : value(x) {}
    Tracked(Quad v, Quad e) : value(v), error(e) {}

    Quad value = 0, error = 0;
};

namespace detail {

/// Adds room for the roundings of the bound itself.
inline Tracked bounded(Quad value, Quad error) {
    return {value, error * Quad(1 + 0x1p-40)};
}

/// Returns whether a number has at most 53 bits, so that the product of two such is exact.
inline bool is_short(Quad x) {
    return static_cast<Quad>(static_cast<double>(x)) == x;
}

}  // namespace detail

inline Tracked operator-(const Tracked& a) {
    return {-a.value, a.error};
}

inline Tracked operator+(const Tracked& a, const Tracked& b) {
    const Quad sum = a.value + b.value;
    const bool exact = sum - a.value == b.value && sum - b.value == a.value;
    const Quad rounding = exact ? Quad(0) : magnitude(sum) * quad_roundoff;
    return detail::bounded(sum, a.error + b.error + rounding);
}

inline Tracked operator-(const Tracked& a, const Tracked& b) {
    return a + (-b);
}

inline Tracked operator*(const Tracked& a, const Tracked& b) {
    const Quad product = a.value * b.value;
    const bool exact = detail::is_short(a.value) && detail::is_short(b.value);
    const Quad rounding = exact ? Quad(0) : magnitude(product) * quad_roundoff;
    if (a.error == 0 && b.error == 0) return detail::bounded(product, rounding);
    const Quad inherited =
        magnitude(a.value) * b.error + magnitude(b.value) * a.error + a.error * b.error;
    return detail::bounded(product, inherited + rounding);
}

/// Returns the quotient; its error is infinite if the divisor may be zero.
inline Tracked operator/(const Tracked& a, const Tracked& b) {
    const Quad least = magnitude(b.value) - b.error;
    if (!(least > 0)) return {0, Quad(infinity)};
    const Quad quotient = a.value / b.value;
    const Quad inherited = (a.error + magnitude(quotient) * b.error) / least;
    return detail::bounded(quotient, inherited + magnitude(quotient) * quad_roundoff);
}

/// Returns the square root; x must be known to be positive.
inline Tracked square_root(const Tracked& x) {
    const Quad root = square_root(x.value);
    return detail::bounded(root, x.error / root + 2 * root * quad_roundoff);
}

inline Certainty is_positive(const Tracked& x) {
    if (x.value > x.error) return Certainty::yes;
    return x.value <= -x.error ? Certainty::no : Certainty::unknown;
}
inline Certainty is_negative(const Tracked& x) {
    return is_positive(-x);
}
inline Certainty is_zero(const Tracked& x) {
    if (magnitude(x.value) > x.error) return Certainty::no;
    return x.value == 0 && x.error == 0 ? Certainty::yes : Certainty::unknown;
}

inline Certainty operator<(const Tracked& a, const Tracked& b) {
    return is_positive(b - a);
}
inline Certainty operator<=(const Tracked& a, const Tracked& b) {
    return !(b < a);
}

struct TrackedVec {
    TrackedVec() = default;
    TrackedVec(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}
    TrackedVec(const Tracked& a, const Tracked& b, const Tracked& c) : x(a), y(b), z(c) {}

    Tracked x, y, z;
};

inline TrackedVec operator+(const TrackedVec& a, const TrackedVec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline TrackedVec operator-(const TrackedVec& a, const TrackedVec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Tracked dot(const TrackedVec& a, const TrackedVec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline TrackedVec cross(const TrackedVec& a, const TrackedVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace etalon
