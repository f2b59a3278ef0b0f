#include "app/compare/limit.h"

#include <fmt/ranges.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/formats/nearest_name.h"

namespace etalon::compare {
namespace {

std::vector<std::string_view> names() {
    std::vector<std::string_view> names;
    for (const Metric& metric : all_metrics()) names.push_back(metric.name);
    return names;
}

}  // namespace

std::string metric_names() {
    return fmt::format("{}", fmt::join(names(), ", "));
}

Result<Limit> parse_limit(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const Metric* metric = find_metric(name);
    if (!metric) {
        return {{},
                fmt::format("{}: expected one of {}{}", name, metric_names(),
                            did_you_mean(name, names()))};
    }
    const std::string value = equals == std::string::npos ? "" : text.substr(equals + 1);
    char* end = nullptr;
    const double worst = std::strtod(value.c_str(), &end);
    if (value.empty() || *end != 0 || std::isnan(worst)) {
        return {{}, fmt::format("{}: expected METRIC=VALUE with a number", text)};
    }
    return {{metric, worst}, {}};
}

std::string violation(const Limit& limit, const Metrics& metrics) {
    const Metric& metric = *limit.metric;
    const double value = metric.of(metrics).get<double>();
    if (metric.larger_is_better ? value >= limit.worst : value <= limit.worst) return {};
    return fmt::format("{} is {:.6g}, {} {:.6g}", metric.name, value,
                       metric.larger_is_better ? "below" : "above", limit.worst);
}

}  // namespace etalon::compare
