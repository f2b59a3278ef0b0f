// Error bounds of a float filter. u = 2^-24. In normalized space, primitives have |p| <= 1 on each
// axis and origins |o| <= 3, so |p - o| <= 4.
//
// A difference p - o is off by 4.6 u: p rounded u/2, o rounded 2.1 u (half a unit in the last place
// of 3, plus the cost of advancing it by up to 2^24 in double), the difference itself 2 u. A fused
// operation has one rounding less than is counted here.
#pragma once

#include "core/numerics/rounding.h"

namespace etalon {

/// Returns a bound on the error of an edge function (Woop, Benthin & Wald 2013, JCGT 2(1)) of a
/// triangle with the given extent in normalized space.
///
/// A sheared coordinate x = (px - ox) - (dx / dz) (pz - oz), |dx / dz| <= 1:
///   the differences 4.6 u each;
///   the slope: dx, dz and the quotient u each, so 3.01 u; times pz - oz 4.6 u + 12.1 u + 2 u;
///   the last difference, of at most 8, 4 u. Together 27.3 u: less than E = 28 u.
///
/// An edge function U = x1 y2 - y1 x2 of a triangle that the ray's line hits: the triangle
/// surrounds the line, so with L its largest extent along an axis |x|, |y| <= X = 2 L. U is off by
/// 4 X E + 2 E^2 from its inputs and 4 u (X + E)^2 <= 0.58 E (X + E) from its roundings, as X <= 4:
/// less than 9.2 E L + 2.6 E^2. Adding 1.8 E L, for the depth of the hit, gives the bound.
inline float edge_error_bound(double extent) {
    constexpr double e = 28 * unit_roundoff_f;
    return float_up(e * (11 * (extent + unit_roundoff_f) + 3 * e));
}

/// Bound on the error of the depths of a triangle and of a ray's end: dz u and the product u, of at
/// most 8, 16 u; a corner's depth 4.6 u; the differences of two, of at most 13, 8 u each; and 2 u
/// for the kernel, whose t is good to u in normalized space (error_bound in distance_of(): at most
/// 2^-26 of the triangle's depth, 2, and 2^-50 of the distance, 2^24).
inline constexpr float depth_error_bound = 48 * unit_roundoff_f;

/// Returns a radius in normalized space that is greater than the distance that the filter computes
/// between a line and a centre, wherever the true distance is at most `radius`.
///
/// The difference f of centre and origin is off by 4.6 sqrt(3) u = 8 u, and |f| <= 4 sqrt(3) < 7;
/// so rotating the direction d by u moves the line's nearest point by 7 u. Its place along the
/// line, f.d / d.d, is off by 8 u |f| / |d| (3 u each for the products, one for the reciprocal and
/// one more): 56 u; f minus that times d by 14 u. Together 85 u. The factor is for the squares: 3 u
/// for the distance's, u for the radius', 6 u for what their difference is compared with.
inline float enlarged_radius(double radius) {
    return float_up(radius * (1 + 0x1p-20) + 88 * unit_roundoff_f);
}

/// Bound on the error of t at the middle of a sphere: 8 u from f, 3 times 7 u from d, 56 u as
/// above, 2 u for the kernel, and up to 18 u for comparing it with a bound of at most 7.
inline constexpr float middle_error_bound = 128 * unit_roundoff_f;

}  // namespace etalon
