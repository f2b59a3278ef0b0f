#include "bench/accuracy/report/points.h"

#include <algorithm>

#include "bench/accuracy/report/cases.h"
#include "bench/statistics/statistics.h"

namespace etalon::accuracy {
namespace {

std::string unit_of(const std::vector<CaseRows>& cases) {
    for (const CaseRows& c : cases) {
        for (const Row* row : c.rows) {
            if (row->cost > 0 && is_textbook(row->tracer)) return row->tracer;
        }
    }
    for (const CaseRows& c : cases) {
        if (c.find(baseline)) return std::string(baseline);
    }
    return {};
}

/// Returns the cost, or 0 if the case has no cost in this unit.
double cost_of(const Row& row, const CaseRows& c, const std::string& unit) {
    if (unit.empty()) return row.nanoseconds;
    if (unit != baseline) return row.cost;
    const Row* one = c.find(baseline);
    return one && one->nanoseconds > 0 ? row.nanoseconds / one->nanoseconds : 0;
}

Point point_of(const std::string& tracer, const std::vector<CaseRows>& cases,
               const std::string& unit) {
    Point point;
    point.tracer = tracer;
    std::vector<double> costs;
    for (const CaseRows& c : cases) {
        const Row* row = c.find(tracer);
        if (row == nullptr) continue;
        const double cost = cost_of(*row, c, unit), error = error_of(row->stats);
        if (cost > 0) costs.push_back(cost);
        if (point.worst_case.empty() || error > point.error) {
            point.error = error;
            point.worst_case = c.name();
        }
        point.exact = row->exact;
    }
    point.cost = statistics::median(costs);
    return point;
}

/// Returns whether `a` is at least as good in both, and better in one.
bool dominates(const Point& a, const Point& b) {
    constexpr double same = 1.01;
    const double error_a = 1 + a.error, error_b = 1 + b.error;
    const bool worse = a.cost > same * b.cost || error_a > same * error_b;
    return !worse && (same * a.cost < b.cost || same * error_a < error_b);
}

}  // namespace

double error_of(const ErrorStats& stats) {
    return std::min(stats.float_ulps.max(), most_ulps) + errors_per_million(stats);
}

void mark_efficient(std::vector<Point>& points) {
    for (Point& p : points) {
        p.efficient = std::none_of(points.begin(), points.end(),
                                   [&](const Point& other) { return dominates(other, p); });
    }
}

Scatter scatter_of(const std::vector<Row>& rows, const std::string& shape) {
    const std::vector<CaseRows> cases = cases_of(rows, shape);
    Scatter scatter{unit_of(cases), cases.size(), {}};
    std::vector<std::string> seen;
    for (const Row& row : rows) {
        const bool known = std::find(seen.begin(), seen.end(), row.tracer) != seen.end();
        if (row.shape != shape || known) continue;
        seen.push_back(row.tracer);
        const Point point = point_of(row.tracer, cases, scatter.unit);
        if (point.cost > 0) scatter.points.push_back(point);
    }
    mark_efficient(scatter.points);
    std::sort(scatter.points.begin(), scatter.points.end(),
              [](const Point& a, const Point& b) { return a.cost < b.cost; });
    return scatter;
}

}  // namespace etalon::accuracy
