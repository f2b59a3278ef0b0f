// How fast pictures come to what they should be.
#include <fmt/format.h>

#include "bench/plot/line_chart.h"
#include "bench/report/sections/sections.h"
#include "bench/report/words.h"

namespace etalon::bench_report {
namespace {

Charts chart_of(const ConvergenceFigures& figures) {
    plot::LineChart chart{figures.scene + ": error against time", "CPU seconds", "relMSE", {}};
    for (const ConvergenceCurve& curve : figures.curves) {
        plot::Series series{curve.name, {}};
        for (const auto& p : curve.points) series.samples.push_back({p.seconds, p.error});
        chart.series.push_back(std::move(series));
    }
    return {{{"relMSE against CPU seconds", plot::line_chart(chart)}}};
}

Table points_of(const ConvergenceFigures& figures) {
    Table table{{{"curve", false}, {"samples a pixel"}, {"CPU s"}, {"relMSE"}}, {}};
    for (const ConvergenceCurve& curve : figures.curves) {
        for (const auto& p : curve.points) {
            table.rows.push_back({{curve.name},
                                  {three_digits(p.samples)},
                                  {three_digits(p.seconds)},
                                  {fmt::format("{:.2e}", p.error)}});
        }
    }
    return table;
}

}  // namespace

Section convergence_section(const Results& results) {
    Section section{"convergence", "Convergence", {}, {}};
    section.prose = {
        "The error of a picture against the time it has taken so far. relMSE is the mean of the "
        "squared difference to a reference by the reference’s own square, plus 0.01: noise as it "
        "is "
        "seen. A line that falls twice as far in the same time is worth twice the machines."};
    const std::string& date = results.convergence.date;
    for (const ConvergenceFigures& figures : results.convergence.list) {
        section.figures.push_back({figures.scene, "Reference: " + figures.reference + ".",
                                   figures.command, date, chart_of(figures)});
        section.figures.push_back({figures.scene + ": all points", "The numbers of this chart.",
                                   figures.command, date, points_of(figures), true});
    }
    return section;
}

}  // namespace etalon::bench_report
