#pragma once

#include "core/numerics/rounding.h"

namespace etalon {

/// Returns how far a unit circle perpendicular to `axis` extends along the unit vectors e_k:
/// sin(axis, e_k).
inline Vec3 reach_of_circle(Vec3 axis) {
    axis = to_unit_magnitude(axis);
    const double length2 = axis.dot(axis);
    Vec3 reach;
    for (int k = 0; k < 3; ++k) {
        const double i = axis[(k + 1) % 3], j = axis[(k + 2) % 3];
        reach[k] = std::sqrt((i * i + j * j) / length2);
    }
    return reach;
}

}  // namespace etalon
