// What the roundings of a float filter can amount to. u = 2^-24; coordinates of the frame: what is
// tested has |p| <= 1 in each axis, origins |o| <= 3, so |p - o| <= 4.
//
// A difference p - o is off by 4.6 u: p rounded u/2, o rounded 2.1 u (half a unit in the last place
// of 3, and what moving it up to 2^24 in double costs), the difference itself 2 u. A fused
// operation has one rounding less than what is counted here.
#pragma once

#include "core/numerics/rounding.h"

namespace etalon {

/// Bound on the error of an edge function (Woop, Benthin & Wald 2013, JCGT 2(1)), for a triangle of
/// so large an extent L in the frame, on a grid of steps g that is as large as its cluster. The
/// function is in steps, the bound derived in the frame: g is a power of two.
///
/// A sheared coordinate is x = (px - ox) - (dx / dz) (pz - oz), |dx / dz| <= 1. With the grid's
/// base b, (bx - ox) - (dx / dz) (bz - oz) is the same for all corners: b is a float, so
///   the differences are off by 4.1 u each;
///   the slope: dx, dz and the quotient u each, so 3.01 u; times bz - oz 4.1 u + 12.1 u + 2 u;
///   the last difference, of at most 8, 4 u. Together 26.3 u: less than C = 27 u.
/// What is added for each corner is off by g / 2 along both axes, so g, by 3.01 u of the grid's
/// extent from the slope, u of it from the product, and by roundings of values that are at most
/// three and two extents where the ray's line meets the triangle: as the extent is less than 2^16
/// g, 9.1 u of it are 0.04 g. Together less than I = 1.05 g.
///
/// An edge function U = x1 y2 - y1 x2 of a triangle that the ray's line meets: it surrounds the
/// line, so |x|, |y| <= X = 2 L, and so are differences of two corners. What is common to corners
/// moves the line, and U by 2 C X; the rest makes 2 X I each for two of them, 4 C I, and 2 I^2.
/// Together 4 C L + 8.4 g L + 4.2 C g + 2.3 g^2. The roundings of U, 4 u (X + C + I)^2, are less
/// than 0.07 g L and hundredths of the others; 24 u L^2 < 0.1 g L is kept for the depth of the hit.
/// That is less than (4 C + 9 g) (L + 1.1 g).
inline float edge_doubt(double extent, double steps_per_unit) {
    constexpr double common = 27 * unit_roundoff_f;
    return float_up((4 * common * steps_per_unit + 9) * (extent * steps_per_unit + 1.1));
}

/// By how much the depths of a triangle and of a ray's end may be off, but for half a step of the
/// triangle's grid: dz u and the product u, of at most 8, 16 u; the depth of the grid's base 4.1 u
/// and of a corner 4 u more; the differences of two, of at most 13, 8 u here and there; and 2 u for
/// the kernel, whose t is good to u in the frame (doubt in distance_of(): at most 2^-26 of the
/// triangle's depth, 2, and 2^-50 of the distance, 2^24).
inline constexpr float depth_doubt = 56 * unit_roundoff_f;

/// A radius in the frame that is greater than what the filter finds the distance between a line and
/// a centre to be, wherever that is at most `radius` in truth.
///
/// The difference f of centre and origin is off by 4.6 sqrt(3) u = 8 u, and |f| <= 4 sqrt(3) < 7;
/// so turning the direction d by u moves the line's nearest point by 7 u. Its place along the line,
/// f.d / d.d, is off by 8 u |f| / |d| (3 u each for the products, one for the reciprocal and one
/// more): 56 u; f less that times d by 14 u. Together 85 u. The factor is for the squares: 3 u for
/// the distance's, u for the radius', 6 u for their difference over d.d.
inline float enlarged_radius(double radius) {
    return float_up(radius * (1 + 0x1p-20) + 88 * unit_roundoff_f);
}

/// By how much t may be off in the middle of a sphere: 8 u from f, 3 times 7 u from d, 56 u as
/// above, 2 u for the kernel; and up to 18 u for the roundings of comparing it with a bound of at
/// most 7.
inline constexpr float middle_doubt = 128 * unit_roundoff_f;

}  // namespace etalon
