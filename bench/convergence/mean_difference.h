#pragma once

#include <cmath>
#include <vector>

#include "bench/convergence/curve.h"

namespace etalon::convergence {

/// Returns the relative difference of each channel's mean from the reference's; 0 where both are 0.
inline Vec3 mean_difference(const Vec3& mean, const Vec3& reference) {
    Vec3 difference;
    for (int k = 0; k < 3; ++k) {
        difference[k] = mean[k] == reference[k] ? 0 : mean[k] / reference[k] - 1;
    }
    return difference;
}

/// Sets mean and standard error of the mean differences of several seeds.
inline void set_mean_difference(const std::vector<Vec3>& seeds, Point& point) {
    const auto n = static_cast<double>(seeds.size());
    Vec3 mean(0), squares(0);
    for (const Vec3& v : seeds) mean += v / n;
    for (const Vec3& v : seeds) squares += (v - mean) * (v - mean);
    point.mean_difference = mean;
    if (seeds.size() < 2) return;
    const Vec3 variance = squares / (n * (n - 1));
    point.mean_difference_error =
        Vec3(std::sqrt(variance.x), std::sqrt(variance.y), std::sqrt(variance.z));
}

}  // namespace etalon::convergence
