// Statistics of a handful of repeats.
#pragma once

#include <vector>

namespace etalon::speed {

/// The value below which a share `q` of the values lies, between neighbours by proportion; 0 if
/// there are none.
double quantile(std::vector<double> values, double q);

inline double median(const std::vector<double>& values) {
    return quantile(values, 0.5);
}

/// A median and how far apart the middle half of the values is.
struct Estimate {
    double median = 0;
    double spread = 0;  ///< interquartile range
};

Estimate estimate(const std::vector<double>& values);

/// Estimates the quotients a[i] / b[i], in which a disturbance of a whole repeat cancels out.
Estimate quotient(const std::vector<double>& a, const std::vector<double>& b);

/// exp of the mean logarithm: the mean of ratios; 0 if there are none.
double geometric_mean(const std::vector<double>& values);

}  // namespace etalon::speed
