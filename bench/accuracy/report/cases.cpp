#include "bench/accuracy/report/cases.h"

#include <algorithm>

namespace etalon::accuracy {

std::string CaseRows::name() const {
    return variant.empty() ? id : id + ", " + variant;
}

const Row* CaseRows::find(std::string_view tracer) const {
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&](const Row* r) { return r->tracer == tracer; });
    return row == rows.end() ? nullptr : *row;
}

const Row& CaseRows::fullest() const {
    return **std::ranges::max_element(rows, {}, [](const Row* row) { return row->stats.rays; });
}

std::vector<std::string> shapes_of(const std::vector<Row>& rows) {
    std::vector<std::string> shapes;
    for (const Row& row : rows) {
        if (std::find(shapes.begin(), shapes.end(), row.shape) == shapes.end())
            shapes.push_back(row.shape);
    }
    return shapes;
}

std::vector<CaseRows> cases_of(const std::vector<Row>& rows, const std::string& shape) {
    std::vector<CaseRows> cases;
    for (const Row& row : rows) {
        if (row.shape != shape) continue;
        auto same = std::find_if(cases.begin(), cases.end(), [&](const CaseRows& c) {
            return c.id == row.id && c.variant == row.variant && c.criterion == row.criterion;
        });
        if (same == cases.end())
            same = cases.insert(same, {row.id, row.variant, row.criterion, {}});
        same->rows.push_back(&row);
    }
    return cases;
}

bool is_textbook(std::string_view tracer) {
    return tracer.starts_with("float ") || tracer.starts_with("double ");
}

double errors_per_million(const ErrorStats& stats) {
    if (stats.decided() == 0) return 0;
    return 1e6 * static_cast<double>(stats.errors()) / static_cast<double>(stats.decided());
}

}  // namespace etalon::accuracy
