#include "bench/accuracy/report/accuracy_table.h"

#include <fmt/format.h>

#include "bench/accuracy/report/cases.h"
#include "bench/accuracy/report/numbers.h"

namespace etalon::accuracy {
namespace {

using table::Detail;

constexpr int name_width = 24;

std::string dot_or(std::uint64_t n) {
    return n == 0 ? "." : brief_count(n);
}

template <std::uint64_t ErrorStats::*Count>
std::string count(const Row& row) {
    return dot_or(row.stats.*Count);
}

std::string wrong(const Row& row) {
    return dot_or(row.stats.errors());
}

template <Distribution ErrorStats::*Values, int Percent>
std::string quantile(const Row& row) {
    const Distribution& values = row.stats.*Values;
    return values.count() > 0 ? brief(values.quantile(Percent / 100.0)) : "-";
}

template <Distribution ErrorStats::*Values>
std::string largest(const Row& row) {
    const Distribution& values = row.stats.*Values;
    return values.count() > 0 ? brief(values.max()) : "-";
}

std::string nanoseconds(const Row& row) {
    return brief(row.nanoseconds);
}

std::string cost(const Row& row) {
    return row.cost == 0 ? "-" : brief(row.cost);
}

using Cell = std::string (*)(const Row& row);

/// Restricts a cell to rows of one criterion; others have no value.
std::function<std::string(const Row& row)> only(const char* criterion, Cell cell) {
    return
        [criterion, cell](const Row& row) { return row.criterion == criterion ? cell(row) : "-"; };
}

std::function<std::string(const Row& row)> by_oracle(Cell cell) {
    return only("oracle", cell);
}

const table::Columns<Row>& columns() {
    using S = ErrorStats;
    static const table::Columns<Row> all = {
        {"", "rays", 8, count<&S::rays>},
        {"", "wrong", 8, wrong, "wrong answers of all kinds"},
        {"false", "hits", 7, by_oracle(count<&S::false_hits>), "a hit where there is nothing"},
        {"false", "misses", 7, by_oracle(count<&S::false_misses>),
         "a miss where there is something"},
        {"wrong", "roots", 7, by_oracle(count<&S::wrong_roots>),
         "right to hit, but off by more than 1/100 of the shape's size", Detail::wide},
        {"wrong", "prims", 7, by_oracle(count<&S::wrong_primitives>),
         "another primitive than the nearest, or at a tie not the lowest", Detail::wide},
        {"", "leaks", 7, only("enclosed", count<&S::leaks>),
         "rays that get out of a closed surface", Detail::wide},
        {"self", "hits", 7, only("spawned", count<&S::self_hits>),
         "spawned rays that meet the surface they left", Detail::wide},
        {"contra-", "dicted", 8, count<&S::contradictions>,
         "the occlusion query says other than the nearest hit", Detail::wide},
        {"other", "bits", 7, count<&S::deviations>, "not the bits of the first exact backend",
         Detail::wide},
        {"", "unsure", 7, count<&S::undecidable>, "rays that the oracle cannot decide"},
        {"float", "p50", 8, by_oracle(quantile<&S::float_ulps, 50>),
         "median error of the distance t, in units in the last place of a float", Detail::wide},
        {"float", "p99", 8, by_oracle(quantile<&S::float_ulps, 99>),
         "the same error, which 99 of 100 rays do not exceed", Detail::wide},
        {"float", "max", 8, by_oracle(largest<&S::float_ulps>),
         "largest error of the distance t, in units in the last place of a float"},
        {"double", "p50", 8, by_oracle(quantile<&S::double_ulps, 50>),
         "median error of t, in units in the last place of a double", Detail::wide},
        {"double", "p99", 8, by_oracle(quantile<&S::double_ulps, 99>),
         "the same error, which 99 of 100 rays do not exceed", Detail::wide},
        {"double", "max", 8, by_oracle(largest<&S::double_ulps>),
         "largest error of t, in units in the last place of a double"},
        {"", "K", 8, by_oracle(largest<&S::conditioned>),
         "largest error of t, in units of what one unit roundoff in each input does to t"},
        {"", "|dP|", 8, by_oracle(largest<&S::position>),
         "largest error of the hit point, relative to the shape's size", Detail::wide},
        {"", "shift", 8, only("spawned", quantile<&S::shift, 50>),
         "median distance from the hit point at which a spawned ray starts, relative to the size",
         Detail::wide},
        {"ns", "a ray", 8, nanoseconds, "nanoseconds of CPU time, median"},
        {"", "cost", 7, cost, "time relative to the first textbook kernel"},
    };
    return all;
}

std::string line(const Row& row, Detail detail) {
    return table::line_of(fmt::format("  {:{}}", row.tracer, name_width - 2), row, columns(),
                          detail);
}

std::string heading(const std::string& shape, Detail detail) {
    return table::heading(fmt::format("{:{}}", shape, name_width), columns(), detail);
}

}  // namespace

std::string table_of(const std::vector<Row>& rows, Detail detail,
                     const std::string& heading_above) {
    std::string text;
    for (const std::string& shape : shapes_of(rows)) {
        if (!text.empty()) text += '\n';
        if (shape != heading_above) text += heading(shape, detail);
        for (const CaseRows& c : cases_of(rows, shape)) {
            text += fmt::format("{} ({})\n", c.name(), c.criterion);
            for (const Row* row : c.rows) text += line(*row, detail);
        }
    }
    return text;
}

std::string legend(Detail detail) {
    table::Legend legend;
    table::explain(columns(), detail, legend);
    legend.add(".", "none");
    legend.add("-", "not looked at in this case, or of no hit");
    legend.add("(oracle)", "hits are compared with the oracle's");
    legend.add("(enclosed)", "rays start inside a closed surface");
    legend.add("(spawned)", "rays start where one hit a surface");
    return legend.text();
}

}  // namespace etalon::accuracy
