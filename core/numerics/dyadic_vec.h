#pragma once

#include "core/numerics/dyadic.h"
#include "core/numerics/vec.h"

namespace etalon {

using DyadicVec = std::array<Dyadic, 3>;

inline DyadicVec exactly(const Vec3& v) {
    return {Dyadic(v.x), Dyadic(v.y), Dyadic(v.z)};
}

inline DyadicVec difference(const Vec3& a, const Vec3& b) {
    return {Dyadic(a.x) - Dyadic(b.x), Dyadic(a.y) - Dyadic(b.y), Dyadic(a.z) - Dyadic(b.z)};
}

inline Dyadic dot(const DyadicVec& a, const DyadicVec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline DyadicVec cross(const DyadicVec& a, const DyadicVec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace etalon
