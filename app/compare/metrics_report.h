// Reports on the difference of two images.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/image/metrics/metrics.h"

namespace etalon::compare {

/// A metric that can be selected by its name.
struct Metric {
    std::string_view name;
    nlohmann::json (*of)(const Metrics& metrics);
    bool larger_is_better;
    std::string_view meaning;
};

/// Returns the metrics in the order of reports. To add one: a member of Metrics, a line here.
std::span<const Metric> all_metrics();

/// Returns a metric by its name; nullptr if there is none.
const Metric* find_metric(std::string_view name);

/// Returns the metrics as JSON. Their keys are stable; values that are not finite are null.
nlohmann::ordered_json as_json(const Metrics& metrics);

std::string as_text(const Metrics& metrics);

}  // namespace etalon::compare
