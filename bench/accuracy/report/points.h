// Points of error over cost for each tracer of a shape.
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/error_stats.h"

namespace etalon::accuracy {

struct Point {
    std::string tracer;
    bool exact = false;
    double cost = 0;   ///< median over the cases, in the unit of the scatter
    double error = 0;  ///< of the worst case: see error_of()
    std::string worst_case;
    bool efficient = false;  ///< in the Pareto set: no tracer is cheaper and as good, or better
};

struct Scatter {
    std::string unit;  ///< what `cost` is relative to; empty if it is in nanoseconds
    std::size_t cases = 0;
    std::vector<Point> points;  ///< by cost
};

/// Error of t in ulp of a float at which no digit of a float is right.
inline constexpr double most_ulps = 0x1p24;

/// Returns the largest error of t in ulp of a float, at most `most_ulps`, plus the number of all
/// errors per million rays.
double error_of(const ErrorStats& stats);

/// Returns the points. Cost is relative to the first textbook kernel if there are rows of it, else
/// to `baseline`, else in nanoseconds. Tracers without a cost have no point.
Scatter scatter_of(const std::vector<Row>& rows, const std::string& shape);

/// Marks the Pareto set. Costs or errors (plus one) within a hundredth count as equal: no plot
/// shows less.
void mark_efficient(std::vector<Point>& points);

}  // namespace etalon::accuracy
