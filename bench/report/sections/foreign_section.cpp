// Section on other programs: error against CPU time of whole processes, compared with Etalon's.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/plot/line_chart.h"
#include "bench/report/command_lines.h"
#include "bench/report/formatting.h"
#include "bench/report/sections/foreign_ratios.h"
#include "bench/report/sections/sections.h"

namespace etalon::bench_report {
namespace {

using namespace convergence;

/// Number of charts that are visible without a click.
constexpr std::size_t shown_charts = 12;

std::string scientific(double value) {
    return std::isfinite(value) ? fmt::format("{:.2e}", value) : "–";
}

plot::Series series_of(const std::string& name, const std::vector<Point>& points,
                       double preparation) {
    plot::Series series{name, {}};
    for (const Point& p : points) {
        series.samples.push_back({preparation + p.cpu_seconds, p.relmse});
    }
    return series;
}

Chart chart_of(const ForeignFigures& figures) {
    plot::LineChart chart{
        figures.scene + ": error against CPU time", "CPU seconds, whole process", "relMSE", {}};
    chart.series.push_back(series_of("Etalon", figures.own.points, figures.own.preparation));
    for (const ForeignCurve& curve : figures.foreign) {
        chart.series.push_back(series_of(curve.program, curve.points, 0));
    }
    return {fmt::format("{}, {} × {} pixels", figures.scene, figures.size.x, figures.size.y),
            line_chart(chart)};
}

/// Charts of the scenes that were compared, from one of them on.
Charts charts_of(const std::vector<ForeignFigures>& all, std::size_t from, std::size_t to) {
    Charts charts;
    for (std::size_t i = from; i < std::min(to, all.size()); ++i) {
        charts.charts.push_back(chart_of(all[i]));
    }
    return charts;
}

Table means_of(const std::vector<ForeignFigures>& compared) {
    Table table{{{"program", false}, {"scenes"}, {"geometric mean"}, {"least"}, {"most"}}, {}};
    for (const ForeignRatios& r : foreign_ratios(compared)) {
        const auto [least, most] = std::ranges::minmax(r.ratios);
        table.rows.push_back({{r.program},
                              {std::to_string(r.ratios.size())},
                              {"×" + three_digits(statistics::geometric_mean(r.ratios))},
                              {"×" + three_digits(least)},
                              {"×" + three_digits(most)}});
    }
    return table;
}

std::string ratio_text(const EqualError& p) {
    return (p.own.extrapolated ? "≈ " : "") + three_digits(p.ratio);
}

/// Largest relative difference of a channel's mean, in percent.
std::string mean_text(const Point& p) {
    if (!p.mean_difference) return "–";
    const Vec3& d = *p.mean_difference;
    double most = 0;
    for (int k = 0; k < 3; ++k) most = std::abs(d[k]) > std::abs(most) ? d[k] : most;
    return fmt::format("{:+.2f}", 100 * most);
}

Table ratios_of(const std::vector<ForeignFigures>& compared) {
    Table table{{{"scene", false},
                 {"program", false},
                 {"a pixel"},
                 {"relMSE"},
                 {"its CPU s"},
                 {"our CPU s"},
                 {"ratio"},
                 {"its mean, %"},
                 {"our mean, %"},
                 {"counts", false}},
                {}};
    for (const ForeignFigures& f : compared) {
        for (const CurveComparison& c : f.comparisons) {
            for (const EqualError& p : c.points) {
                table.rows.push_back(
                    {{f.scene},
                     {c.program},
                     {p.foreign.samples > 0 ? three_digits(p.foreign.samples) : "–"},
                     {scientific(p.foreign.relmse)},
                     {three_digits(p.foreign.cpu_seconds)},
                     {three_digits(p.own.cpu_seconds)},
                     {ratio_text(p)},
                     {mean_text(p.foreign)},
                     {mean_text(f.own.points.back())},
                     {f.is_same ? "yes" : "no"}});
            }
        }
    }
    return table;
}

Table missing_of(const std::vector<ForeignFigures>& all) {
    Table table{{{"scene", false}, {"why", false}}, {}};
    for (const ForeignFigures& f : all) {
        if (!f.missing.empty()) table.rows.push_back({{f.scene}, {f.missing}});
    }
    return table;
}

std::vector<ForeignFigures> compared_of(const std::vector<ForeignFigures>& all) {
    std::vector<ForeignFigures> compared;
    std::ranges::copy_if(all, std::back_inserter(compared),
                         [](const ForeignFigures& f) { return f.missing.empty(); });
    return compared;
}

const std::vector<std::string> prose = {
    "Images of other programs, and the CPU time that each took as a process of one thread, from "
    "the table that this report was given. Errors of all are measured against the same reference. "
    "Our time includes the start of the process, reading the scene and building.",
    "The ratio is the other program’s CPU time over ours to its error: that on the line between "
    "the points of our curve in the logarithms of both. ≈ marks one beyond the ends of our "
    "curve, where the error is taken to fall as 1 / time; where a scene has others it is not in "
    "the means. A scene counts where the mean of each channel of our images is within 0.5 % of "
    "the reference’s, or 3 of its standard errors: where both programs render the same. Other "
    "programs’ times are as the table has them: a machine that was busy when they were measured "
    "makes a ratio as wrong."};

}  // namespace

Section foreign_section(const Results& results) {
    Section section{"foreign", "Comparison with other programs", prose, {}};
    const std::vector<ForeignFigures> compared = compared_of(results.foreign.list);
    const std::string command = foreign_command(results.settings);
    const auto add = [&](const char* title, const char* caption, auto content, bool folded) {
        section.figures.push_back(
            {title, caption, command, results.foreign.date, std::move(content), folded});
    };
    if (!compared.empty()) {
        add("CPU time to equal error",
            "Other programs’ CPU time over ours, geometric means over the scenes that count.",
            means_of(compared), false);
        add("Error against CPU time",
            "Error against CPU seconds of one thread, both by logarithms.",
            charts_of(compared, 0, shown_charts), false);
        if (compared.size() > shown_charts) {
            add("Error against CPU time, the other scenes", "The same of the scenes after those.",
                charts_of(compared, shown_charts, compared.size()), true);
        }
        add("Ratios",
            "Each image of another program beside our curve. Means are the channel’s that differs "
            "most from the reference’s; ours at the end of the curve.",
            ratios_of(compared), false);
    }
    if (const Table missing = missing_of(results.foreign.list); !missing.rows.empty()) {
        add("Not compared", "Scenes of the table that are not in the figures above.", missing,
            false);
    }
    return section;
}

}  // namespace etalon::bench_report
