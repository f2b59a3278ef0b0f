#include "app/compare/limit.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/formats/nearest_name.h"

namespace etalon::compare {
namespace {

std::string unknown(const std::string& name) {
    std::vector<std::string_view> names;
    std::string list;
    for (const Metric& metric : all_metrics()) {
        names.push_back(metric.name);
        list += (list.empty() ? "" : ", ") + std::string(metric.name);
    }
    return fmt::format("{}: expected one of {}{}", name, list, did_you_mean(name, names));
}

}  // namespace

Result<Limit> parse_limit(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const Metric* metric = find_metric(name);
    if (!metric) return {{}, unknown(name)};
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
    if (metric.falls ? value >= limit.worst : value <= limit.worst) return {};
    return fmt::format("{} is {:.6g}, {} {:.6g}", metric.name, value,
                       metric.falls ? "below" : "above", limit.worst);
}

}  // namespace etalon::compare
