// Double-double arithmetic (Dekker 1971): sums and products to 2^-102 of their operands.
#pragma once

#include "core/numerics/exact.h"

namespace etalon {

inline TwoTerm operator+(const TwoTerm& a, const TwoTerm& b) {
    const TwoTerm s = two_sum(a.value, b.value);
    return two_sum(s.value, s.error + (a.error + b.error));
}
inline TwoTerm operator*(const TwoTerm& a, const TwoTerm& b) {
    const TwoTerm p = two_product(a.value, b.value);
    return two_sum(p.value, p.error + (a.value * b.error + a.error * b.value));
}
inline TwoTerm operator-(const TwoTerm& a) {
    return {-a.value, -a.error};
}

using Vec3TwoTerm = std::array<TwoTerm, 3>;

inline Vec3TwoTerm two_terms(const Vec3& v) {
    return {TwoTerm{v.x, 0}, TwoTerm{v.y, 0}, TwoTerm{v.z, 0}};
}

inline Vec3TwoTerm operator+(const Vec3TwoTerm& a, const Vec3TwoTerm& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// Returns a - b exactly.
inline Vec3TwoTerm two_differences(const Vec3& a, const Vec3& b) {
    return {two_difference(a.x, b.x), two_difference(a.y, b.y), two_difference(a.z, b.z)};
}

inline Vec3TwoTerm cross(const Vec3TwoTerm& a, const Vec3TwoTerm& b) {
    return {a[1] * b[2] + -(a[2] * b[1]), a[2] * b[0] + -(a[0] * b[2]),
            a[0] * b[1] + -(a[1] * b[0])};
}

inline Vec3 rounded(const Vec3TwoTerm& v) {
    return {v[0].value, v[1].value, v[2].value};
}

}  // namespace etalon
