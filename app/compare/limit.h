#pragma once

#include <string>

#include "app/compare/metrics_report.h"
#include "core/base/result.h"

namespace etalon::compare {

/// The worst acceptable value of a metric.
struct Limit {
    const Metric* metric = nullptr;
    double worst = 0;
};

/// Returns the names of all metrics: "mse, relmse, ...".
std::string metric_names();

/// Parses METRIC=VALUE, or returns what is wrong with it.
Result<Limit> parse_limit(const std::string& text);

/// Returns the message for a metric worse than its limit; empty if it is not.
std::string violation(const Limit& limit, const Metrics& metrics);

}  // namespace etalon::compare
