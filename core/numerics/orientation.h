#pragma once

#include <cmath>

#include "core/numerics/exact.h"
#include "core/numerics/rounding.h"
#include "core/numerics/vec.h"

namespace etalon {

/// Returns twice the signed area of the triangle (a, b, c), positive if it is counter-clockwise,
/// with the exact sign. A plain double's error is bounded by three roundings in either product and
/// one in their difference.
inline double orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
    const Vec2 u = b - a, v = c - a;
    const double p = u.x * v.y, q = u.y * v.x;
    const double bound = 5 * unit_roundoff * (std::abs(p) + std::abs(q)) + 0x1p-1000;
    if (std::abs(p - q) > bound) return p - q;
    if ((u.x == 0 || v.y == 0) && (u.y == 0 || v.x == 0)) return 0;
    return exact_edge_sign({a.x, a.y, 0}, {0, 0, 1}, {b.x, b.y, 0}, {c.x, c.y, 0});
}

}  // namespace etalon
