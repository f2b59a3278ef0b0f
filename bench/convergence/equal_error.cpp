#include "bench/convergence/equal_error.h"

#include <algorithm>
#include <cmath>

#include "bench/statistics/statistics.h"

namespace etalon::convergence {
namespace {

/// Returns the CPU seconds of the whole process at a point of a curve.
double whole_seconds(const Curve& curve, const Point& p) {
    return curve.preparation + p.cpu_seconds;
}

/// Extrapolates from one end of a curve, with an error that falls as 1 / time.
TimeToError extrapolated(const Curve& curve, const Point& end, double relmse) {
    return {curve.preparation + end.cpu_seconds * end.relmse / relmse, true};
}

TimeToError between(const Curve& curve, const Point& a, const Point& b, double relmse) {
    const double share = std::log(relmse / a.relmse) / std::log(b.relmse / a.relmse);
    const double from = std::log(whole_seconds(curve, a)), to = std::log(whole_seconds(curve, b));
    return {std::exp(from + share * (to - from)), false};
}

/// Geometric mean of the ratios that are extrapolated, or of those that are not.
double mean_ratio(const std::vector<EqualError>& points, bool extrapolated) {
    std::vector<double> ratios;
    for (const EqualError& p : points) {
        if (p.own.extrapolated == extrapolated) ratios.push_back(p.ratio);
    }
    return statistics::geometric_mean(ratios);
}

CurveComparison compare(const Curve& own, const ForeignCurve& foreign) {
    CurveComparison c{foreign.program, own.name, {}};
    for (const Point& p : foreign.points) {
        if (!has_error(p)) continue;
        const TimeToError time = time_to_relmse(own, p.relmse);
        c.points.push_back({p, time, p.cpu_seconds / time.cpu_seconds});
    }
    c.extrapolated =
        std::ranges::all_of(c.points, [](const EqualError& p) { return p.own.extrapolated; });
    c.ratio = mean_ratio(c.points, c.extrapolated);
    return c;
}

}  // namespace

bool has_error(const Point& p) {
    return p.relmse > 0 && std::isfinite(p.relmse);
}

TimeToError time_to_relmse(const Curve& curve, double relmse) {
    std::vector<Point> points;
    std::ranges::copy_if(curve.points, std::back_inserter(points), has_error);
    if (points.empty()) return {};
    if (points.back().relmse > relmse) return extrapolated(curve, points.back(), relmse);
    for (std::size_t i = points.size() - 1; i > 0; --i) {
        if (points[i - 1].relmse >= relmse && points[i].relmse < points[i - 1].relmse) {
            return between(curve, points[i - 1], points[i], relmse);
        }
    }
    return extrapolated(curve, points.front(), relmse);
}

std::vector<CurveComparison> compare(const std::vector<Curve>& own,
                                     const std::vector<ForeignCurve>& foreign) {
    std::vector<CurveComparison> all;
    for (const Curve& curve : own) {
        if (std::ranges::none_of(curve.points, has_error)) continue;
        for (const ForeignCurve& other : foreign) {
            CurveComparison c = compare(curve, other);
            if (!c.points.empty()) all.push_back(std::move(c));
        }
    }
    return all;
}

}  // namespace etalon::convergence
