// CPU time of two renderers to one error.
#pragma once

#include <string>
#include <vector>

#include "bench/convergence/curve.h"

namespace etalon::convergence {

/// CPU time, all of the process included, after which an image has some error.
struct TimeToError {
    double cpu_seconds = 0;
    /// The error is beyond the ends of the curve, where it is taken to fall as 1 / time.
    bool extrapolated = false;
};

/// Returns the time to a relMSE above 0: interpolated between the points of the curve, linearly in
/// the logarithms of error and time, where the curve falls below it for the last time.
TimeToError time_to_relmse(const Curve& curve, double relmse);

/// A point of another program's curve beside a curve of this one.
struct EqualError {
    Point foreign;
    TimeToError own;
    double ratio = 0;  ///< the other program's CPU seconds over those of this one
};

/// Comparison of two curves.
struct CurveComparison {
    std::string program, curve;  ///< their names
    std::vector<EqualError> points;
    double ratio = 0;           ///< geometric mean over the points that are not extrapolated
    bool extrapolated = false;  ///< there are none: it is the mean of all
};

/// Compares all curves of this program with all of others. Points and curves without an error above
/// 0 are left out.
std::vector<CurveComparison> compare(const std::vector<Curve>& own,
                                     const std::vector<ForeignCurve>& foreign);

}  // namespace etalon::convergence
