#include "core/numerics/catmull_rom.h"

#include <algorithm>
#include <cmath>

namespace etalon {
namespace {

constexpr double tolerance = 1e-9;  ///< of t

/// Returns the zero of an increasing function between 0 and 1, by Newton's method safeguarded with
/// bisection.
template <class Function, class Derivative>
double root(const Function& f, const Derivative& derivative, double t) {
    double a = 0, b = 1;
    for (int steps = 0; steps < 64 && b - a > tolerance; ++steps) {
        if (!(t > a && t < b)) t = (a + b) / 2;
        const double value = f(t);
        if (value == 0) break;
        (value < 0 ? a : b) = t;
        const double step = value / derivative(t);
        t -= step;
        if (std::abs(step) < tolerance) break;
    }
    return std::clamp(t, a, b);
}

}  // namespace

double SplineSegment::value(double t) const {
    return f0 + t * (slope0 + t * (-2 * slope0 - slope1 + 3 * (f1 - f0) +
                                   t * (slope0 + slope1 + 2 * (f0 - f1))));
}

double SplineSegment::derivative(double t) const {
    return slope0 + t * (2 * (-2 * slope0 - slope1 + 3 * (f1 - f0)) +
                         t * 3 * (slope0 + slope1 + 2 * (f0 - f1)));
}

double SplineSegment::integral(double t) const {
    return t * (f0 + t * (slope0 / 2 + t * ((-2 * slope0 - slope1) / 3 + f1 - f0 +
                                            t * ((slope0 + slope1) / 4 + (f0 - f1) / 2))));
}

double SplineSegment::t_of_integral(double sum) const {
    // Start from the root of a straight line.
    const double rise = f1 - f0;
    const double start =
        rise != 0 ? (std::sqrt(std::max(0.0, f0 * f0 + 2 * sum * rise)) - f0) / rise : sum / f0;
    return root([&](double t) { return integral(t) - sum; }, [&](double t) { return value(t); },
                start);
}

double SplineSegment::t_of_value(double of) const {
    return root([&](double t) { return value(t) - of; }, [&](double t) { return derivative(t); },
                0.5);
}

std::optional<SplineWeights> spline_weights(std::span<const float> nodes, float x) {
    if (!(x >= nodes.front() && x <= nodes.back())) return std::nullopt;
    const std::size_t i =
        spline_interval(nodes.size(), [&](std::size_t k) { return nodes[k] <= x; });
    const float x0 = nodes[i], x1 = nodes[i + 1], width = x1 - x0;
    const float t = (x - x0) / width, t2 = t * t, t3 = t2 * t;
    // From value and derivative at both ends; the derivatives are differences of values.
    const float slope0 = t3 - 2 * t2 + t, slope1 = t3 - t2;
    SplineWeights w{i, {0, 2 * t3 - 3 * t2 + 1, 3 * t2 - 2 * t3, 0}};
    const float before = i > 0 ? slope0 * width / (x1 - nodes[i - 1]) : slope0;
    w.weights[i > 0 ? 0 : 1] -= before;
    w.weights[2] += before;
    const bool has_next = i + 2 < nodes.size();
    const float after = has_next ? slope1 * width / (nodes[i + 2] - x0) : slope1;
    w.weights[1] -= after;
    w.weights[has_next ? 3 : 2] += after;
    return w;
}

float integrate_spline(std::span<const float> nodes, std::span<const float> values,
                       std::span<float> sums) {
    double sum = 0;
    sums[0] = 0;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        const auto segment = spline_segment(
            nodes, [&](std::size_t k) -> double { return values[k]; }, i);
        sum += segment.width * segment.integral(1);
        sums[i + 1] = static_cast<float>(sum);
    }
    return sums.back();
}

float invert_spline(std::span<const float> nodes, std::span<const float> values, float value) {
    if (!(value > values.front())) return nodes.front();
    if (!(value < values.back())) return nodes.back();
    const std::size_t i =
        spline_interval(nodes.size(), [&](std::size_t k) { return values[k] <= value; });
    const auto segment = spline_segment(
        nodes, [&](std::size_t k) -> double { return values[k]; }, i);
    return static_cast<float>(segment.begin + segment.width * segment.t_of_value(value));
}

}  // namespace etalon
