#include "bench/convergence/curve_report.h"

#include <fmt/format.h>

#include "bench/convergence/point_format.h"
#include "bench/table/columns.h"

namespace etalon::convergence {
namespace {

using Json = nlohmann::ordered_json;

/// Returns null for an unknown value.
Json json_of(const std::optional<Fit>& fit, double Fit::*value) {
    return fit ? Json((*fit).*value) : Json();
}

template <double Point::*Value>
std::string scientific_cell(const Point& p) {
    return scientific(p.*Value);
}

const table::Columns<Point>& columns() {
    static const table::Columns<Point> all = {
        {"", "spp", 10, [](const Point& p) { return spp_text(p.samples); }, "samples per pixel"},
        {"", "CPU s", 11, [](const Point& p) { return fmt::format("{:.4f}", p.cpu_seconds); },
         "CPU seconds of rendering until then, one thread"},
        {"", "relMSE", 12, scientific_cell<&Point::relmse>,
         "mean of the squared errors, each over the reference's square plus 0.01"},
        {"", "MSE", 12, scientific_cell<&Point::mse>, "mean squared error, the mean of all seeds"},
        {"MSE", "least", 12, scientific_cell<&Point::mse_least>, "that of the best seed"},
        {"MSE", "most", 12, scientific_cell<&Point::mse_most>, "that of the worst seed"},
        {"difference of", "mean R, G, B, %", 24,
         [](const Point& p) { return percent_text(p.mean_difference); },
         "mean of a channel over the reference's, less 1"},
    };
    return all;
}

std::string law_of(const std::optional<Fit>& fit) {
    if (!fit) return "too few points for a law";
    return fmt::format("MSE falls as time^{:.2f}, floor {:.1e}", fit->slope, fit->floor);
}

}  // namespace

nlohmann::ordered_json json_of(const Curve& curve) {
    Json points = Json::array();
    for (const Point& p : curve.points) {
        points.push_back({{"spp", p.samples},
                          {"cpu_seconds", p.cpu_seconds},
                          {"mse", p.mse},
                          {"mse_least", p.mse_least},
                          {"mse_most", p.mse_most},
                          {"relmse", p.relmse},
                          {"mean_difference", json_of(p.mean_difference)},
                          {"mean_difference_error", json_of(p.mean_difference_error)}});
    }
    return {{"name", curve.name},
            {"sampler", curve.sampler},
            {"backend", curve.backend},
            {"integrator", curve.integrator},
            {"seeds", curve.seeds},
            {"preparation_cpu_seconds", curve.preparation},
            {"slope", json_of(curve.fit, &Fit::slope)},
            {"floor", json_of(curve.fit, &Fit::floor)},
            {"points", points},
            {"efficiency", curve.efficiency()}};
}

std::string table_of(const Curve& curve) {
    std::string text =
        fmt::format("{}; {} seed{}\n", curve.name, curve.seeds, curve.seeds == 1 ? "" : "s") +
        table::heading("", columns(), table::Detail::narrow);
    for (const Point& p : curve.points) {
        text += table::line_of("", p, columns(), table::Detail::narrow);
    }
    return text + fmt::format("  {}; 1/(MSE s) {:.3e}; {:.3f} CPU s before rendering\n",
                              law_of(curve.fit), curve.efficiency(), curve.preparation);
}

void explain_curve(table::Legend& legend) {
    table::explain(columns(), table::Detail::narrow, legend);
    legend.add("floor", "MSE that no time takes away: bias, or the noise of the reference");
    legend.add("1/(MSE s)", "efficiency at the curve's end: twice as high is worth twice the time");
    legend.add("before rendering", "starting the process, reading the scene, building");
}

}  // namespace etalon::convergence
