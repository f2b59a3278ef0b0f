#include "bench/statistics/statistics.h"

#include <algorithm>
#include <cmath>

namespace etalon::statistics {

double quantile(std::vector<double> values, double q) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const double place = q * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

Estimate estimate(const std::vector<double>& values) {
    if (values.size() < 2) return {median(values), std::nullopt};
    return {median(values), quantile(values, 0.75) - quantile(values, 0.25)};
}

Estimate quotient(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> quotients;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        quotients.push_back(a[i] / b[i]);
    }
    return estimate(quotients);
}

double geometric_mean(const std::vector<double>& values) {
    if (values.empty()) return 0;
    double sum = 0;
    for (const double v : values) sum += std::log(v);
    return std::exp(sum / static_cast<double>(values.size()));
}

}  // namespace etalon::statistics
