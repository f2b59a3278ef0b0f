// The colour spaces of FLIP, in double precision, for sRGB's primaries and white.
#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Convert between linear RGB and L*a*b* without its cube roots: luminance Y in [-16, 100] and two
/// opponent colours, linear in RGB, so that filters may average them.
Vec3 ycxcz_of_linear(const Vec3& rgb);
Vec3 linear_of_ycxcz(const Vec3& ycxcz);

/// Returns CIE L*a*b* with a* and b* scaled by L* / 100, as colours look fainter in the dark
/// (Hunt).
Vec3 hunt_lab_of_linear(const Vec3& rgb);

/// Returns the distance of two such colours: city block in L*, Euclidean in (a*, b*) (Abasi et al.
/// 2019).
double hyab(const Vec3& a, const Vec3& b);

}  // namespace etalon
