// Section on convergence: the error of images against time.
#include <fmt/format.h>

#include <algorithm>

#include "bench/plot/line_chart.h"
#include "bench/report/command_lines.h"
#include "bench/report/formatting.h"
#include "bench/report/sections/sections.h"

namespace etalon::bench_report {
namespace {

using convergence::Curve;
using convergence::Point;

Chart chart_of(const ConvergenceFigures& figures) {
    const ConvergenceRequest& r = figures.request;
    plot::LineChart chart{r.scene + ": error against time", "CPU seconds", "MSE", {}};
    for (const Curve& curve : figures.curves) {
        const bool is_usual = curve.backend == figures.curves.front().backend;
        plot::Series series{is_usual ? curve.sampler : curve.backend, {}};
        for (const Point& p : curve.points) {
            series.samples.push_back({p.cpu_seconds, p.mse, p.mse_least, p.mse_most});
        }
        chart.series.push_back(std::move(series));
    }
    return {fmt::format("{}, {} × {} pixels", r.scene, r.width, r.height),
            line_chart(chart),
            {fmt::format("The reference has {}.", figures.reference)}};
}

std::string scientific(double value) {
    return value == 0 ? "0" : fmt::format("{:.2e}", value);
}

Table curves_of(const std::vector<ConvergenceFigures>& all) {
    Table table{{{"scene", false},
                 {"samples", false},
                 {"CPU s"},
                 {"MSE"},
                 {"slope"},
                 {"floor"},
                 {"1 / (MSE s)"}},
                {}};
    for (const ConvergenceFigures& figures : all) {
        for (const Curve& curve : figures.curves) {
            if (curve.points.empty()) continue;
            const Point& last = curve.points.back();
            table.rows.push_back({{figures.request.scene},
                                  {curve.name},
                                  {three_digits(last.cpu_seconds)},
                                  {scientific(last.mse)},
                                  {curve.fit ? fmt::format("{:.2f}", curve.fit->slope) : "–"},
                                  {curve.fit ? scientific(curve.fit->floor) : "–"},
                                  {three_digits(curve.efficiency())}});
        }
    }
    return table;
}

Table points_of(const std::vector<ConvergenceFigures>& all) {
    Table table{{{"scene", false}, {"samples", false}, {"a pixel"}, {"CPU s"}, {"MSE"}, {"relMSE"}},
                {}};
    for (const ConvergenceFigures& figures : all) {
        for (const Curve& curve : figures.curves) {
            for (const Point& p : curve.points) {
                table.rows.push_back({{figures.request.scene},
                                      {curve.name},
                                      {three_digits(p.samples)},
                                      {three_digits(p.cpu_seconds)},
                                      {scientific(p.mse)},
                                      {scientific(p.relmse)}});
            }
        }
    }
    return table;
}

/// Returns "3 seeds", or "1 to 3 seeds" where the last curve was stopped.
std::string seeds_of(const std::vector<ConvergenceFigures>& all, int wanted) {
    int least = wanted;
    for (const ConvergenceFigures& figures : all) {
        for (const Curve& curve : figures.curves) least = std::min(least, curve.seeds);
    }
    return least < wanted ? fmt::format("{} to {} seeds", least, wanted)
                          : fmt::format("{} seeds", wanted);
}

std::string command(const Results& results) {
    std::string all;
    for (const ConvergenceFigures& figures : results.convergence.list) {
        all += (all.empty() ? "" : " && ") + convergence_command(results.settings, figures.request);
    }
    return all;
}

}  // namespace

Section convergence_section(const Results& results) {
    Section section{"convergence", "Convergence", {}, {}};
    section.prose = {
        "The error of an image against rendering time, on one thread, for samples "
        "that fall anywhere (random), evenly (sobol), and where they lower the error most "
        "(adaptive), the last also by another backend, by its name. A line twice as low at the "
        "same time is worth twice the machines; one that "
        "levels off has a floor that no time takes away."};
    const std::vector<ConvergenceFigures>& all = results.convergence.list;
    if (all.empty()) return section;
    Charts charts;
    for (const ConvergenceFigures& figures : all) charts.charts.push_back(chart_of(figures));
    const std::string date = results.convergence.date;
    section.figures = {
        {"Error against time",
         fmt::format("Mean squared error to a reference image; means of {}, whose range is "
                     "shaded. Both axes by logarithms.",
                     seeds_of(all, results.settings.convergence_seeds)),
         command(results), date, std::move(charts)},
        {"The curves’ ends and slopes",
         "Slope is that of log error against log time; 1 / (MSE s) grows with what a machine is "
         "worth.",
         command(results), date, curves_of(all)},
        {"All points of these curves", "Error and CPU time after each round of samples.",
         command(results), date, points_of(all), true}};
    return section;
}

}  // namespace etalon::bench_report
