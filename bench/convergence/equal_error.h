// CPU times of two renderers to the same error.
#pragma once

#include <string>
#include <vector>

#include "bench/convergence/curve.h"

namespace etalon::convergence {

/// CPU time of a whole process until an image has a given error.
struct TimeToError {
    double cpu_seconds = 0;
    /// The error is beyond the ends of the curve, where it is assumed to fall as 1 / time.
    bool extrapolated = false;
};

/// Returns whether a time to the point's error exists: that is neither 0 nor infinite.
bool has_error(const Point& p);

/// Returns the time to a relMSE above 0: interpolated between the points of the curve, linearly in
/// the logarithms of error and time, where the curve falls below it for the last time.
TimeToError time_to_relmse(const Curve& curve, double relmse);

/// A point of another program's curve compared with a curve of this one.
struct EqualError {
    Point foreign;
    TimeToError own;
    double ratio = 0;  ///< CPU seconds of the other program over those of this one
};

/// Comparison of two curves.
struct CurveComparison {
    std::string program, curve;  ///< their names
    std::vector<EqualError> points;
    double ratio = 0;           ///< geometric mean over the points that are not extrapolated
    bool extrapolated = false;  ///< all points are extrapolated: the mean is over all
};

/// Compares all curves of this program with all of others. Points and curves without an error above
/// 0 are left out.
std::vector<CurveComparison> compare(const std::vector<Curve>& own,
                                     const std::vector<ForeignCurve>& foreign);

}  // namespace etalon::convergence
