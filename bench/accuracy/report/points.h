// Error against cost: where each tracer stands for a shape.
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
    bool efficient = false;  ///< in the Pareto set: nobody is cheaper and as good, or better
};

struct Scatter {
    std::string unit;  ///< what `cost` is relative to; empty if it is in nanoseconds
    std::size_t cases = 0;
    std::vector<Point> points;  ///< by cost
};

/// An error of t in ulp of a float from which on no digit of a float is right.
inline constexpr double most_ulps = 0x1p24;

/// The largest error of t in ulp of a float, taken as `most_ulps` at most, plus all that went wrong
/// in a million rays.
double error_of(const ErrorStats& stats);

/// Cost is relative to the first textbook kernel where rows are, else to `baseline`, else in
/// nanoseconds. Who has no cost has no point.
Scatter scatter_of(const std::vector<Row>& rows, const std::string& shape);

/// Costs or errors (plus one) within a hundredth count as equal: no plot shows less.
void mark_efficient(std::vector<Point>& points);

}  // namespace etalon::accuracy
