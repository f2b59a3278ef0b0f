// Reports on the difference of two images.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/image/metrics/metrics.h"

namespace etalon::compare {

/// A number that may be asked for by its name.
struct Metric {
    std::string_view name;
    nlohmann::json (*of)(const Metrics& metrics);
    bool falls;  ///< the larger the better; else the smaller
    std::string_view meaning;
};

/// Returns the metrics in the order of reports. To add one: a member of Metrics, a line here.
std::span<const Metric> all_metrics();

/// nullptr if there is none of that name.
const Metric* find_metric(std::string_view name);

/// The metrics' keys are a contract. What is not finite is null.
nlohmann::ordered_json as_json(const Metrics& metrics);

std::string as_text(const Metrics& metrics);

}  // namespace etalon::compare
