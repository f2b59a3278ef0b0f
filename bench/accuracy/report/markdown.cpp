#include "bench/accuracy/report/markdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "bench/accuracy/report/cases.h"
#include "bench/accuracy/report/numbers.h"

namespace etalon::accuracy {
namespace {

/// A column: its name and its text for a case, empty if it has no value.
struct Column {
    std::string name;
    std::string (*cell)(const CaseRows& c);
};

const Row* first_textbook(const CaseRows& c) {
    const auto row = std::find_if(c.rows.begin(), c.rows.end(),
                                  [](const Row* r) { return is_textbook(r->tracer); });
    return row == c.rows.end() ? nullptr : *row;
}

std::string rays(const CaseRows& c) {
    return brief_count(c.fullest().stats.rays);
}

/// Returns "0 in 4 backends", or the errors of each if they differ, which would be a defect.
std::string exact_errors(const CaseRows& c) {
    std::set<std::uint64_t> errors;
    std::string each;
    int backends = 0;
    for (const Row* row : c.rows) {
        if (!row->exact || row->tracer == bare_kernel) continue;
        errors.insert(row->stats.errors());
        each += fmt::format("{}{} {}", each.empty() ? "" : ", ", row->tracer, row->stats.errors());
        ++backends;
    }
    if (errors.size() != 1) return each;
    return fmt::format("{} in {} backend{}", *errors.begin(), backends, backends == 1 ? "" : "s");
}

std::string undecidable(const CaseRows& c) {
    return brief_count(c.fullest().stats.undecidable);
}

/// Returns the errors of the kernel alone or, if it was not measured, of an exact backend.
std::string kernel_ulps(const CaseRows& c) {
    const Row* row = c.find(bare_kernel);
    for (const Row* other : c.rows) {
        if (row == nullptr && other->exact) row = other;
    }
    if (row == nullptr || row->stats.double_ulps.count() == 0) return {};
    const Distribution& ulps = row->stats.double_ulps;
    return fmt::format("{} / {}", brief(ulps.quantile(0.5)), brief(ulps.max()));
}

std::string kernel_condition(const CaseRows& c) {
    const Row* row = c.find(bare_kernel);
    return row && row->stats.conditioned.count() > 0 ? brief(row->stats.conditioned.max()) : "";
}

std::string kernel_cost(const CaseRows& c) {
    const Row* row = c.find(bare_kernel);
    return row && row->cost > 0 ? "×" + brief(row->cost) : "";
}

std::string error_rate(const Row* row) {
    if (row == nullptr) return {};
    const double errors = errors_per_million(row->stats);
    return errors < 10 ? fmt::format("{:.2g}", errors) : fmt::format("{:.0f}", errors);
}

std::string float_ulps(const Row* row) {
    if (row == nullptr || row->stats.float_ulps.count() == 0) return {};
    return brief(row->stats.float_ulps.quantile(0.5)) + " / " + brief(row->stats.float_ulps.max());
}

std::string textbook_name(const std::vector<CaseRows>& cases) {
    for (const CaseRows& c : cases) {
        if (const Row* row = first_textbook(c)) return row->tracer;
    }
    return {};
}

std::vector<Column> all_columns(const std::vector<CaseRows>& cases) {
    const std::string builtin(baseline), textbook = textbook_name(cases);
    return {
        {"case", [](const CaseRows& c) { return c.name(); }},
        {"rays", rays},
        {"undecidable", undecidable},
        {"exact: errors", exact_errors},
        {"t, double ulp", kernel_ulps},
        {"K", kernel_condition},
        {"cost", kernel_cost},
        {builtin + ": errors per 10⁶",
         [](const CaseRows& c) { return error_rate(c.find(baseline)); }},
        {"t, float ulp", [](const CaseRows& c) { return float_ulps(c.find(baseline)); }},
        {textbook + ": errors per 10⁶",
         [](const CaseRows& c) { return error_rate(first_textbook(c)); }},
        {"t, float ulp", [](const CaseRows& c) { return float_ulps(first_textbook(c)); }},
    };
}

/// Returns the columns that have a value for at least one case.
std::vector<Column> columns_for(const std::vector<CaseRows>& cases) {
    std::vector<Column> columns = all_columns(cases);
    std::erase_if(columns, [&](const Column& column) {
        return std::all_of(cases.begin(), cases.end(),
                           [&](const CaseRows& c) { return column.cell(c).empty(); });
    });
    return columns;
}

std::string table_of(const std::vector<CaseRows>& cases) {
    const std::vector<Column> columns = columns_for(cases);
    std::string names = "|", rule = "|", lines;
    for (const Column& column : columns) {
        names += fmt::format(" {} |", column.name);
        rule += &column == columns.data() ? "---|" : "--:|";
    }
    for (const CaseRows& c : cases) {
        lines += "|";
        for (const Column& column : columns) {
            const std::string cell = column.cell(c);
            lines += fmt::format(" {} |", cell.empty() ? "–" : cell);
        }
        lines += "\n";
    }
    return names + "\n" + rule + "\n" + lines;
}

}  // namespace

std::string markdown(const std::vector<Row>& rows) {
    std::string text;
    for (std::string shape : shapes_of(rows)) {
        const std::vector<CaseRows> cases = cases_of(rows, shape);
        shape[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(shape[0])));
        text += fmt::format("{}## {}\n\n{}", text.empty() ? "" : "\n", shape, table_of(cases));
    }
    return text;
}

}  // namespace etalon::accuracy
