#include "bench/convergence/foreign_report.h"

#include <fmt/format.h>

#include <cmath>

#include "bench/convergence/point_format.h"
#include "bench/table/columns.h"
#include "bench/table/csv.h"

namespace etalon::convergence {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t name_width = 40;

const table::Columns<Point>& image_columns() {
    static const table::Columns<Point> all = {
        {"", "spp", 10, [](const Point& p) { return spp_text(p.samples); }},
        {"", "CPU s", 11, [](const Point& p) { return fmt::format("{:.4f}", p.cpu_seconds); }},
        {"", "relMSE", 12, [](const Point& p) { return scientific(p.relmse); }},
        {"", "MSE", 12, [](const Point& p) { return scientific(p.mse); }},
        {"1 /", "(relMSE s)", 12, [](const Point& p) { return scientific(p.efficiency()); },
         "efficiency: twice as high is worth twice the time"},
        {"difference of", "mean R, G, B, %", 24,
         [](const Point& p) { return percent_text(p.mean_difference); },
         "mean of a channel over the reference's, less 1"},
    };
    return all;
}

const table::Columns<EqualError>& comparison_columns() {
    static const table::Columns<EqualError> all = {
        {"", "spp", 10, [](const EqualError& p) { return spp_text(p.foreign.samples); }},
        {"", "relMSE", 12, [](const EqualError& p) { return scientific(p.foreign.relmse); }},
        {"its", "CPU s", 11,
         [](const EqualError& p) { return fmt::format("{:.4f}", p.foreign.cpu_seconds); },
         "CPU seconds that the other program took to this relMSE, the whole process"},
        {"our", "CPU s", 11,
         [](const EqualError& p) { return fmt::format("{:.4f}", p.own.cpu_seconds); },
         "those of this program, reading and building included, on the line between the points of "
         "its curve in the logarithms of relMSE and time"},
        {"", "ratio", 10, [](const EqualError& p) { return fmt::format("{:.2f}", p.ratio); },
         "its CPU s over our CPU s: how many times less this program needs"},
        {"", "", 14, [](const EqualError& p) { return p.own.extrapolated ? "extrapolated" : ""; }},
    };
    return all;
}

template <class Line, class Lines>
std::string table_of(const std::string& title, const table::Columns<Line>& columns,
                     const Lines& lines) {
    std::string text = title + "\n" + table::heading("", columns, table::Detail::narrow);
    for (const Line& line : lines) {
        text += table::line_of("", line, columns, table::Detail::narrow);
    }
    return text;
}

/// Fields of a point that every line of the CSV begins with.
std::vector<std::string> csv_fields(const std::string& name, const Point& p, double preparation) {
    const auto number = [](double value) {
        return std::isfinite(value) ? fmt::format("{}", value) : "";
    };
    std::vector<std::string> fields{name,
                                    p.samples > 0 ? number(p.samples) : "",
                                    number(preparation + p.cpu_seconds),
                                    number(p.mse),
                                    number(p.relmse),
                                    number(p.efficiency(preparation))};
    for (int k = 0; k < 3; ++k) {
        fields.push_back(p.mean_difference ? number((*p.mean_difference)[k]) : "");
    }
    return fields;
}

std::string csv_of(const CurveComparison& c) {
    std::string text;
    for (const EqualError& p : c.points) {
        std::vector<std::string> fields = csv_fields(c.program, p.foreign, 0);
        for (std::string field :
             {c.curve, fmt::format("{}", p.own.cpu_seconds), fmt::format("{}", p.ratio),
              std::string(p.own.extrapolated ? "yes" : "no")}) {
            fields.push_back(std::move(field));
        }
        text += table::csv_line(fields);
    }
    return text;
}

/// Returns the lines of points without a comparison.
std::string csv_of(const std::string& name, const std::vector<Point>& points, double preparation) {
    std::string text;
    for (const Point& p : points) {
        std::vector<std::string> fields = csv_fields(name, p, preparation);
        fields.resize(fields.size() + 4);
        text += table::csv_line(fields);
    }
    return text;
}

/// Returns the lines of another program: its comparisons, then its points that have none.
std::string csv_of(const ForeignCurve& foreign, const std::vector<CurveComparison>& comparisons) {
    std::string text;
    std::vector<Point> rest = foreign.points;
    for (const CurveComparison& c : comparisons) {
        if (c.program != foreign.program) continue;
        text += csv_of(c);
        std::erase_if(rest, has_error);
    }
    return text + csv_of(foreign.program, rest, 0);
}

}  // namespace

Json json_of(const ForeignCurve& curve) {
    Json points = Json::array();
    for (const Point& p : curve.points) {
        points.push_back({{"spp", p.samples > 0 ? Json(p.samples) : Json()},
                          {"cpu_seconds", p.cpu_seconds},
                          {"mse", p.mse},
                          {"relmse", p.relmse},
                          {"mean_difference", json_of(p.mean_difference)},
                          {"efficiency", p.efficiency()}});
    }
    return {{"program", curve.program}, {"points", points}};
}

Json json_of(const CurveComparison& comparison) {
    Json points = Json::array();
    for (const EqualError& p : comparison.points) {
        points.push_back({{"relmse", p.foreign.relmse},
                          {"foreign_cpu_seconds", p.foreign.cpu_seconds},
                          {"cpu_seconds", p.own.cpu_seconds},
                          {"ratio", p.ratio},
                          {"extrapolated", p.own.extrapolated}});
    }
    return {{"program", comparison.program},
            {"curve", comparison.curve},
            {"points", points},
            {"ratio", comparison.ratio},
            {"extrapolated", comparison.extrapolated}};
}

std::string table_of(const ForeignCurve& curve) {
    return table_of<Point>(curve.program.substr(0, name_width), image_columns(), curve.points);
}

std::string table_of(const CurveComparison& c) {
    const std::string title = fmt::format("{} beside {}", c.program.substr(0, name_width), c.curve);
    return table_of<EqualError>(title, comparison_columns(), c.points) +
           fmt::format("  CPU time to equal relMSE: {:.2f} times less, geometric mean{}\n", c.ratio,
                       c.extrapolated ? " of extrapolated times" : "");
}

void explain_foreign(table::Legend& legend) {
    table::explain(image_columns(), table::Detail::narrow, legend);
    table::explain(comparison_columns(), table::Detail::narrow, legend);
    legend.add("extrapolated",
               "beyond the ends of our curve, where relMSE is taken to fall as 1 / time; not in "
               "the mean where other points are");
}

std::string csv_of(const std::vector<Curve>& own, const std::vector<ForeignCurve>& foreign,
                   const std::vector<CurveComparison>& comparisons) {
    std::string text =
        table::csv_line({"curve", "spp", "cpu_s", "mse", "relmse", "efficiency",
                         "mean_difference_r", "mean_difference_g", "mean_difference_b",
                         "compared_with", "cpu_s_to_equal_relmse", "ratio", "extrapolated"});
    for (const Curve& curve : own) text += csv_of(curve.name, curve.points, curve.preparation);
    for (const ForeignCurve& curve : foreign) text += csv_of(curve, comparisons);
    return text;
}

}  // namespace etalon::convergence
