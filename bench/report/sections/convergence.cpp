// How fast pictures come to what they should be.
#include <fmt/format.h>

#include "bench/plot/line_chart.h"
#include "bench/report/sections/sections.h"
#include "bench/report/words.h"

namespace etalon::bench_report {
namespace {

Chart chart_of(const ConvergenceFigures& figures) {
    plot::LineChart chart{figures.scene + ": error against time", "CPU seconds", "relMSE", {}};
    for (const ConvergenceCurve& curve : figures.curves) {
        plot::Series series{curve.name, {}};
        for (const auto& p : curve.points) series.samples.push_back({p.seconds, p.error});
        chart.series.push_back(std::move(series));
    }
    return {figures.scene, plot::line_chart(chart)};
}

Table points_of(const std::vector<ConvergenceFigures>& all) {
    Table table{{{"scene", false}, {"samples", false}, {"a pixel"}, {"CPU s"}, {"relMSE"}}, {}};
    for (const ConvergenceFigures& figures : all) {
        for (const ConvergenceCurve& curve : figures.curves) {
            for (const auto& p : curve.points) {
                table.rows.push_back({{figures.scene},
                                      {curve.name},
                                      {three_digits(p.samples)},
                                      {three_digits(p.seconds)},
                                      {fmt::format("{:.2e}", p.error)}});
            }
        }
    }
    return table;
}

}  // namespace

Section convergence_section(const Results& results) {
    Section section{"convergence", "Convergence", {}, {}};
    section.prose = {
        "The error of a picture against the time it has taken so far, for samples that fall "
        "anywhere "
        "(random), evenly (sobol), and where they lower the error most (adaptive), which stop when "
        "the error is expected to be that of all the even ones. relMSE is the mean of the squared "
        "difference to a reference by the reference’s own square, plus 0.01: noise as it is seen."};
    const std::vector<ConvergenceFigures>& all = results.convergence.list;
    if (all.empty()) return section;
    Charts charts;
    for (const ConvergenceFigures& figures : all) charts.charts.push_back(chart_of(figures));
    const std::string command = all.front().command, date = results.convergence.date;
    section.figures = {
        {"Error against time", "Reference: " + all.front().reference + ". Both axes by logarithms.",
         command, date, std::move(charts)},
        {"All points of these curves", "Error and CPU time after each round of samples.", command,
         date, points_of(all), true}};
    return section;
}

}  // namespace etalon::bench_report
