// Statistics of a few measurements.
#pragma once

#include <optional>
#include <vector>

namespace etalon::statistics {

/// Returns the quantile `q` of the values, linearly interpolated; 0 if there are none.
double quantile(std::vector<double> values, double q);

/// Returns the median, the mean of the two in the middle if their number is even; 0 if there are
/// none.
inline double median(const std::vector<double>& values) {
    return quantile(values, 0.5);
}

/// A median and the interquartile range.
struct Estimate {
    double median = 0;
    std::optional<double> spread;  ///< interquartile range; unknown of fewer than two values
};

Estimate estimate(const std::vector<double>& values);

/// Estimates the quotients a[i] / b[i], in which a disturbance of a whole repeat cancels out.
Estimate quotient(const std::vector<double>& a, const std::vector<double>& b);

/// Returns the geometric mean; 0 if there are no values.
double geometric_mean(const std::vector<double>& values);

}  // namespace etalon::statistics
