#pragma once

#include "core/numerics/dyadic.h"
#include "core/numerics/vec.h"

namespace etalon {

using DyadicVec = std::array<Dyadic, 3>;

inline DyadicVec exactly(const Vec3& v) {
    return {Dyadic(v.x), Dyadic(v.y), Dyadic(v.z)};
}

inline DyadicVec operator+(const DyadicVec& a, const DyadicVec& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline DyadicVec operator-(const DyadicVec& a, const DyadicVec& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline DyadicVec difference(const Vec3& a, const Vec3& b) {
    return exactly(a) - exactly(b);
}

inline Dyadic dot(const DyadicVec& a, const DyadicVec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline DyadicVec cross(const DyadicVec& a, const DyadicVec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace etalon
