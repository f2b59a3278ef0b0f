// Statistics of a few repeats.
#pragma once

#include <vector>

namespace etalon::speed {

/// Returns the quantile `q` of the values, linearly interpolated; 0 if there are none.
double quantile(std::vector<double> values, double q);

inline double median(const std::vector<double>& values) {
    return quantile(values, 0.5);
}

/// A median and the interquartile range.
struct Estimate {
    double median = 0;
    double spread = 0;  ///< interquartile range
};

Estimate estimate(const std::vector<double>& values);

/// Estimates the quotients a[i] / b[i], in which a disturbance of a whole repeat cancels out.
Estimate quotient(const std::vector<double>& a, const std::vector<double>& b);

/// Returns the geometric mean; 0 if there are no values.
double geometric_mean(const std::vector<double>& values);

}  // namespace etalon::speed
