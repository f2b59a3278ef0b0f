// Classification of a kernel's answers as right or wrong.
#pragma once

#include "core/oracle/oracle.h"
#include "tests/intersect/shape_cases.h"

namespace etalon {

enum class Classification {
    right,         ///< the oracle's class, and its t to within 4 ulp
    nearly_right,  ///< right for a ray that starts a few roundings away
    undecidable,
    wrong
};

/// Returns how a kernel's answer compares with the oracle's. It must be the oracle's answer for the
/// ray, or for a ray whose origin is off by `roundings` u (distance + size + coordinates), or its
/// direction by `roundings` u: no method in double can do better where a rounding of the input
/// decides. This replaces a tolerance: it is loose exactly where the geometry is ill-conditioned
/// (grazing rays, far origins), and nowhere else. For the shapes that promise it
/// (ShapeCase::exact), whether the ray's line meets the shape must be exactly the oracle's answer.
Classification classify(const ShapeCase& shape, const Oracle& oracle, const Ray& ray, double t,
                        double roundings = 8);

/// Returns |t - the true t| in units of the last place of the true t.
double ulps_off(const OracleAnswer& answer, double t);

}  // namespace etalon
