#pragma once

#include <array>

#include "core/numerics/vec.h"

namespace etalon {

/// The control points of a cubic Bezier curve.
using CubicPoints = std::array<Vec3, 4>;

/// Interpolates between two points: a at 0, b at 1.
inline Vec3 between(const Vec3& a, const Vec3& b, double part) {
    return (1 - part) * a + part * b;
}

/// Returns the blossom of a curve: its multi-affine form, which equals the curve where the three
/// arguments are equal (Ramshaw 1989).
inline Vec3 blossom(const CubicPoints& p, double r, double s, double t) {
    const Vec3 a = between(p[0], p[1], r), b = between(p[1], p[2], r), c = between(p[2], p[3], r);
    return between(between(a, b, s), between(b, c, s), t);
}

/// Returns the part of a curve between two parameters.
inline CubicPoints part_of(const CubicPoints& p, double begin, double end) {
    return {blossom(p, begin, begin, begin), blossom(p, begin, begin, end),
            blossom(p, begin, end, end), blossom(p, end, end, end)};
}

/// Returns both halves of a curve: they are the first four and the last four points.
inline std::array<Vec3, 7> halves_of(const CubicPoints& p) {
    const Vec3 a = 0.5 * (p[0] + p[1]), b = 0.5 * (p[1] + p[2]), c = 0.5 * (p[2] + p[3]);
    const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c);
    return {p[0], a, ab, 0.5 * (ab + bc), bc, c, p[3]};
}

/// Returns the derivative of a curve. Where it vanishes, as between two coincident control points,
/// returns the vector from end to end.
inline Vec3 derivative_of(const CubicPoints& p, double u) {
    const Vec3 a = between(p[0], p[1], u), b = between(p[1], p[2], u), c = between(p[2], p[3], u);
    const Vec3 along = 3.0 * (between(b, c, u) - between(a, b, u));
    return along == Vec3(0) ? p[3] - p[0] : along;
}

}  // namespace etalon
