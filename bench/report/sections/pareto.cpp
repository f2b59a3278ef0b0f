// Section on cost against error for each shape.
#include <fmt/format.h>

#include <algorithm>

#include "bench/accuracy/report/cases.h"
#include "bench/accuracy/report/numbers.h"
#include "bench/accuracy/report/plot.h"
#include "bench/accuracy/report/points.h"
#include "bench/accuracy/report/remarks.h"
#include "bench/hard_cases/hard_case.h"
#include "bench/report/command_lines.h"
#include "bench/report/formatting.h"
#include "bench/report/sections/sections.h"

namespace etalon::bench_report {
namespace {

using accuracy::brief;
using accuracy::Row;

Table points_of(const std::vector<Row>& rows) {
    Table table{{{"shape", false},
                 {"tracer", false},
                 {"cost"},
                 {"error"},
                 {"worst case", false},
                 {"Pareto set", false}},
                {}};
    for (const std::string& shape : accuracy::shapes_of(rows)) {
        for (const accuracy::Point& p : accuracy::scatter_of(rows, shape).points) {
            table.rows.push_back({{shape},
                                  {p.tracer},
                                  {brief(p.cost)},
                                  {brief(p.error)},
                                  {p.worst_case},
                                  {p.efficient ? "yes" : ""}});
        }
    }
    return table;
}

/// Returns the number of hard cases of a shape.
std::size_t cases_of_shape(const std::string& shape) {
    const std::vector<hard::HardCase> all = hard::hard_cases();
    return static_cast<std::size_t>(std::ranges::count(all, shape, &hard::HardCase::shape));
}

}  // namespace

Section pareto_section(const Results& results) {
    Section section{"pareto", "Cost against error", {}, {}};
    section.prose = {
        "Where each tracer stands on a shape’s hard cases: to the right what a ray costs, "
        "relative to the kernel of the textbooks in float; upwards its error in the worst case, "
        "the error of t in ulp of a float plus wrong answers in a million rays. Best is the "
        "lower left. Filled marks are the Pareto set, which nothing beats in both, and have their "
        "names; the others say theirs where a pointer rests on them and in the table.",
        fmt::format("An error of t counts as {} ulp at most, where no digit of a float is right.",
                    brief(accuracy::most_ulps))};
    const std::vector<Row>& rows = results.rows.list;
    Charts charts{{}, {{1, "promises to be right"}, {7, "textbook kernel"}, {2, "float backend"}}};
    for (const std::string& shape : accuracy::shapes_of(rows)) {
        std::string svg = accuracy::small_plot(rows, shape);
        if (svg.empty()) continue;
        charts.charts.push_back(
            {fmt::format("{}, {}", shape, count_of(accuracy::cases_of(rows, shape).size(), "case")),
             std::move(svg), accuracy::remarks_on(rows, shape, cases_of_shape(shape))});
    }
    if (charts.charts.empty()) return section;
    const std::string command = accuracy_command(results.settings);
    section.figures.push_back({"Shape by shape",
                               "Error of the worst case against the median cost of a ray, both by "
                               "logarithms.",
                               command, results.rows.date, std::move(charts)});
    section.figures.push_back({"All points of these plots",
                               "Cost relative to the first textbook kernel, where the scene is one "
                               "primitive, else to embree-builtin.",
                               command, results.rows.date, points_of(rows), true});
    return section;
}

}  // namespace etalon::bench_report
