// Section on hard cases: which tracers pass.
#include <fmt/format.h>

#include <algorithm>

#include "app/common/backends.h"
#include "bench/accuracy/report/cases.h"
#include "bench/report/command_lines.h"
#include "bench/report/formatting.h"
#include "bench/report/sections/sections.h"

namespace etalon::bench_report {
namespace {

using accuracy::CaseRows;
using accuracy::Row;

constexpr const char* textbook = "textbook";

/// The textbook kernel in float: the first textbook kernel of each shape, whose names differ. The
/// others are in the plots.
const Row* find(const CaseRows& c, const std::string& name) {
    if (name != textbook) return c.find(name);
    const auto found = std::find_if(c.rows.begin(), c.rows.end(), [](const Row* row) {
        return accuracy::is_textbook(row->tracer);
    });
    return found == c.rows.end() ? nullptr : *found;
}

/// Returns the names of the tracers that have a column.
std::vector<std::string> shown_tracers(const std::vector<Row>& rows) {
    std::vector<std::string> names;
    const auto add = [&](std::string_view name) {
        const bool takes_part =
            std::any_of(rows.begin(), rows.end(), [&](const Row& r) { return r.tracer == name; });
        if (takes_part) names.emplace_back(name);
    };
    const auto add_backends = [&](bool exact) {
        for (const Backend& backend : all_backends()) {
            if (backend.exact == exact) add(backend.name);
        }
    };
    add_backends(true);
    add(accuracy::bare_kernel);
    add_backends(false);
    names.emplace_back(textbook);
    return names;
}

std::vector<Column> columns_for(const std::vector<std::string>& first,
                                const std::vector<std::string>& tracers) {
    std::vector<Column> columns;
    for (const std::string& name : first)
        columns.push_back({name, columns.size() >= first.size() - 1});
    for (const std::string& name : tracers) columns.push_back({name});
    return columns;
}

Cell classification(const Row* row) {
    if (row == nullptr || row->stats.decided() == 0) return {"–"};
    const std::uint64_t errors = row->stats.errors();
    if (errors == 0) return {"pass", Mark::good};
    return {fmt::format("fail: {}", grouped(errors)), Mark::bad};
}

/// Returns the number of decided rays.
std::uint64_t rays_of(const CaseRows& c) {
    std::uint64_t most = 0;
    for (const Row* row : c.rows) most = std::max(most, row->stats.decided());
    return most;
}

/// "51 of 51" cases passed.
Cell passed(const std::vector<CaseRows>& cases, const std::string& tracer) {
    std::size_t tried = 0, right = 0;
    for (const CaseRows& c : cases) {
        const Row* row = find(c, tracer);
        if (row == nullptr || row->stats.decided() == 0) continue;
        ++tried;
        right += row->stats.errors() == 0;
    }
    if (tried == 0) return {"–"};
    return {fmt::format("{} of {}", right, tried), right == tried ? Mark::good : Mark::bad};
}

Table by_shape(const std::vector<Row>& rows) {
    const std::vector<std::string> tracers = shown_tracers(rows);
    Table table{columns_for({"shape", "cases", "rays"}, tracers), {}};
    for (const std::string& shape : accuracy::shapes_of(rows)) {
        const std::vector<CaseRows> cases = accuracy::cases_of(rows, shape);
        std::uint64_t rays = 0;
        for (const CaseRows& c : cases) rays += rays_of(c);
        std::vector<Cell> line{{shape}, {grouped(cases.size())}, {grouped(rays)}};
        for (const std::string& name : tracers) line.push_back(passed(cases, name));
        table.rows.push_back(std::move(line));
    }
    table.columns[1].is_number = true;
    return table;
}

Table cases_of_shape(const std::vector<Row>& rows, const std::string& shape) {
    const std::vector<std::string> tracers = shown_tracers(rows);
    const std::vector<CaseRows> cases = accuracy::cases_of(rows, shape);
    Table table{columns_for({"case", "rays"}, tracers), {}};
    for (const CaseRows& c : cases) {
        std::vector<Cell> line{{c.name()}, {grouped(rays_of(c))}};
        for (const std::string& name : tracers) line.push_back(classification(find(c, name)));
        table.rows.push_back(std::move(line));
    }
    return table;
}

}  // namespace

Section hard_cases_section(const Results& results) {
    Section section{"hard-cases", "Hard cases: pass or fail", {}, {}};
    section.prose = {
        "Constructions on which ray tracers fail: silhouettes, edges, tips, grazing rays, objects "
        "far away, tiny objects, and surfaces that a ray has just left. Random rays rarely find "
        "such errors; all rays here are aimed. A case is passed if all its rays are answered "
        "correctly. Rays that even the oracle cannot decide are not counted; no error in N rays "
        "bounds the error rate by 3 / N (95 % confidence)."};
    const std::vector<Row>& rows = results.rows.list;
    if (rows.empty()) return section;
    const std::string command = accuracy_command(results.settings);
    section.figures.push_back(
        {"Cases passed",
         "“kernel” is the project’s own, by itself; “textbook” is what textbooks print, in float.",
         command, results.rows.date, by_shape(rows)});
    for (const std::string& shape : accuracy::shapes_of(rows)) {
        const std::size_t count = accuracy::cases_of(rows, shape).size();
        section.figures.push_back({fmt::format("{}: {}", shape, count_of(count, "case")),
                                   "Where a case is failed, the number of wrong answers.",
                                   accuracy_command(results.settings, rows, shape),
                                   results.rows.date, cases_of_shape(rows, shape), true});
    }
    return section;
}

}  // namespace etalon::bench_report
