#pragma once

#include "core/numerics/affine.h"

namespace etalon {

/// A quaternion. One of unit length is a rotation, the same one as its negative.
struct Quaternion {
    Vec3 v{0, 0, 0};
    double w = 1;

    double dot(const Quaternion& other) const { return v.dot(other.v) + w * other.w; }
};

/// Returns the quaternion of a rotation, of unit length.
Quaternion quaternion_of(const Affine& rotation);

/// Returns the rotation of a quaternion of unit length.
Affine rotation_of(const Quaternion& q);

Quaternion normalized(const Quaternion& q);

inline Quaternion operator*(double factor, const Quaternion& q) {
    return {factor * q.v, factor * q.w};
}
inline Quaternion operator+(const Quaternion& a, const Quaternion& b) {
    return {a.v + b.v, a.w + b.w};
}

}  // namespace etalon
