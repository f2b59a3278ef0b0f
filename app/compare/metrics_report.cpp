#include "app/compare/metrics_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace etalon::compare {
namespace {

using Json = nlohmann::json;

constexpr Metric metrics_table[] = {
    {"mse", [](const Metrics& m) { return Json(m.mse); }, false, "mean of (A - B)^2"},
    {"relmse", [](const Metrics& m) { return Json(m.relmse); }, false,
     "mean of (A - B)^2 / (B^2 + 0.01)"},
    {"mae", [](const Metrics& m) { return Json(m.mae); }, false, "mean of |A - B|"},
    {"psnr", [](const Metrics& m) { return Json(m.psnr); }, true, "dB, of values up to 1"},
    {"ssim", [](const Metrics& m) { return Json(m.ssim); }, true, "1 where A and B are alike"},
    {"flip", [](const Metrics& m) { return Json(m.flip); }, false,
     "difference seen, 67 pixels a degree"},
    {"max_abs", [](const Metrics& m) { return Json(m.max_abs); }, false, "largest |A - B|"},
    {"different_pixels", [](const Metrics& m) { return Json(m.different_pixels); }, false,
     "in any channel, by however little"},
};

std::string number(const Json& value) {
    return value.is_number_float() ? fmt::format("{:.6g}", value.get<double>()) : value.dump();
}

std::string color(const Vec3& c) {
    return fmt::format("{:.6g} {:.6g} {:.6g}", c.x, c.y, c.z);
}

}  // namespace

std::span<const Metric> all_metrics() {
    return metrics_table;
}

const Metric* find_metric(std::string_view name) {
    const auto* found = std::find_if(std::begin(metrics_table), std::end(metrics_table),
                                     [&](const Metric& m) { return m.name == name; });
    return found == std::end(metrics_table) ? nullptr : found;
}

nlohmann::ordered_json as_json(const Metrics& m) {
    nlohmann::ordered_json json;
    for (const Metric& metric : metrics_table) json[std::string(metric.name)] = metric.of(m);
    json["mean_a"] = {m.mean_a.x, m.mean_a.y, m.mean_a.z};
    json["mean_b"] = {m.mean_b.x, m.mean_b.y, m.mean_b.z};
    return json;
}

std::string as_text(const Metrics& m) {
    std::string text;
    for (const Metric& metric : metrics_table) {
        text +=
            fmt::format("{:<16}  {:>12}  {}\n", metric.name, number(metric.of(m)), metric.meaning);
    }
    text += fmt::format("{:<16}  {}\n{:<16}  {}\n", "mean of A", color(m.mean_a), "mean of B",
                        color(m.mean_b));
    return text;
}

}  // namespace etalon::compare
