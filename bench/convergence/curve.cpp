#include "bench/convergence/curve.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

namespace etalon::convergence {
namespace {

/// Smallest number of samples from which the error follows the fitted power law.
constexpr double fewest_samples = 4;

/// Number of points, at the end of a curve, from which the floor is estimated.
constexpr std::ptrdiff_t last_points = 4;

/// Best fitting line through (x, y).
struct Line {
    double slope, at_zero;
};

/// Fits a line by least squares; `weight` is the weight of a point's squared residual.
template <class X, class Y, class Weight>
Line line_through(std::span<const Point> points, const X& x, const Y& y, const Weight& weight) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const Point& p : points) {
        const double w = weight(p);
        n += w, sx += w * x(p), sy += w * y(p), sxx += w * x(p) * x(p), sxy += w * x(p) * y(p);
    }
    const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    return {slope, (sy - slope * sx) / n};
}

double slope_of(std::span<const Point> points) {
    return line_through(
               points, [](const Point& p) { return std::log(p.cpu_seconds); },
               [](const Point& p) { return std::log(p.mse); }, [](const Point&) { return 1; })
        .slope;
}

/// Fits relative residuals, so that no point dominates.
double floor_of(std::span<const Point> points) {
    return line_through(
               points, [](const Point& p) { return 1 / p.samples; },
               [](const Point& p) { return p.mse; },
               [](const Point& p) { return 1 / (p.mse * p.mse); })
        .at_zero;
}

}  // namespace

double Curve::efficiency() const {
    if (points.empty()) return 0;
    return 1 / (points.back().mse * points.back().cpu_seconds);
}

std::optional<Fit> fit(const std::vector<Point>& points) {
    std::vector<Point> used;
    std::copy_if(points.begin(), points.end(), std::back_inserter(used), [](const Point& p) {
        return p.samples >= fewest_samples && p.mse > 0 && p.cpu_seconds > 0;
    });
    if (used.size() < 3) return std::nullopt;
    const auto count = std::min<std::ptrdiff_t>(last_points, std::ssize(used));
    return Fit{slope_of(used), std::max(0.0, floor_of({used.end() - count, used.end()}))};
}

}  // namespace etalon::convergence
