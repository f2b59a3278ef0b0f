#include "bench/accuracy/report/accuracy_table.h"

#include <fmt/format.h>

#include "bench/accuracy/report/cases.h"
#include "bench/accuracy/report/numbers.h"

namespace etalon::accuracy {
namespace {

constexpr int name_width = 24;

/// Kinds of rows for which a column has a value.
enum class Asked { always, by_oracle, of_enclosed, of_spawned };

struct Column {
    const char *above, *name;
    int width;
    Asked asked;
    std::string (*cell)(const Row& row);
};

template <std::uint64_t ErrorStats::*Count>
std::string count(const Row& row) {
    return row.stats.*Count == 0 ? "." : brief_count(row.stats.*Count);
}

template <Distribution ErrorStats::*Values, int Percent>
std::string quantile(const Row& row) {
    return brief((row.stats.*Values).quantile(Percent / 100.0));
}

template <Distribution ErrorStats::*Values>
std::string largest(const Row& row) {
    return brief((row.stats.*Values).max());
}

std::string cost(const Row& row) {
    return row.cost == 0 ? "-" : brief(row.cost);
}

constexpr Column columns[] = {
    {"", "rays", 7, Asked::always, count<&ErrorStats::rays>},
    {"false", "hits", 7, Asked::by_oracle, count<&ErrorStats::false_hits>},
    {"false", "misses", 7, Asked::by_oracle, count<&ErrorStats::false_misses>},
    {"wrong", "roots", 7, Asked::by_oracle, count<&ErrorStats::wrong_roots>},
    {"wrong", "prims", 7, Asked::by_oracle, count<&ErrorStats::wrong_primitives>},
    {"", "leaks", 7, Asked::of_enclosed, count<&ErrorStats::leaks>},
    {"self-", "hits", 7, Asked::of_spawned, count<&ErrorStats::self_hits>},
    {"contra", "dicted", 7, Asked::always, count<&ErrorStats::contradictions>},
    {"other", "bits", 7, Asked::always, count<&ErrorStats::deviations>},
    {"", "unsure", 7, Asked::always, count<&ErrorStats::undecidable>},
    {"t, in", "p50", 8, Asked::by_oracle, quantile<&ErrorStats::float_ulps, 50>},
    {"float", "p99", 7, Asked::by_oracle, quantile<&ErrorStats::float_ulps, 99>},
    {"ulp", "max", 7, Asked::by_oracle, largest<&ErrorStats::float_ulps>},
    {"double", "p50", 8, Asked::by_oracle, quantile<&ErrorStats::double_ulps, 50>},
    {"ulp", "p99", 7, Asked::by_oracle, quantile<&ErrorStats::double_ulps, 99>},
    {"", "max", 7, Asked::by_oracle, largest<&ErrorStats::double_ulps>},
    {"", "K", 7, Asked::by_oracle, largest<&ErrorStats::conditioned>},
    {"", "|dP|", 7, Asked::by_oracle, largest<&ErrorStats::position>},
    {"", "shift", 7, Asked::of_spawned, quantile<&ErrorStats::shift, 50>},
    {"ns", "a ray", 7, Asked::always, [](const Row& row) { return brief(row.nanoseconds); }},
    {"", "cost", 6, Asked::always, cost},
};

bool is_asked(Asked asked, const std::string& criterion) {
    switch (asked) {
        case Asked::by_oracle:
            return criterion == "oracle";
        case Asked::of_enclosed:
            return criterion == "enclosed";
        case Asked::of_spawned:
            return criterion == "spawned";
        case Asked::always:
            break;
    }
    return true;
}

std::string heading(const std::string& shape) {
    std::string above = fmt::format("{:{}}", "", name_width);
    std::string below = fmt::format("{:{}}", shape, name_width);
    for (const Column& c : columns) {
        above += fmt::format("{:>{}}", c.above, c.width);
        below += fmt::format("{:>{}}", c.name, c.width);
    }
    return above + "\n" + below + "\n";
}

std::string line(const Row& row) {
    std::string text = fmt::format("  {:{}}", row.tracer, name_width - 2);
    for (const Column& c : columns) {
        text +=
            fmt::format("{:>{}}", is_asked(c.asked, row.criterion) ? c.cell(row) : "-", c.width);
    }
    return text + "\n";
}

}  // namespace

std::string table(const std::vector<Row>& rows, const std::string& heading_above) {
    std::string text;
    for (const std::string& shape : shapes_of(rows)) {
        if (shape != heading_above) text += (text.empty() ? "" : "\n") + heading(shape);
        for (const CaseRows& c : cases_of(rows, shape)) {
            text += fmt::format("{} ({})\n", c.name(), c.criterion);
            for (const Row* row : c.rows) text += line(*row);
        }
    }
    return text;
}

}  // namespace etalon::accuracy
