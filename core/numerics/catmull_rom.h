// Cubic splines through values at unevenly spaced nodes, with the derivatives of Catmull & Rom
// 1974: differences of the neighbours' values. At the ends they are one-sided.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace etalon {

/// One segment of a spline, parametrized by t from 0 to 1.
struct SplineSegment {
    double begin, width;            ///< position of the segment
    double f0, f1, slope0, slope1;  ///< values and derivatives by t at its ends

    double value(double t) const;
    double derivative(double t) const;  ///< by t
    double integral(double t) const;    ///< from 0 to t
    /// Returns t for a part `sum` of the integral, for a segment without negative values.
    double t_of_integral(double sum) const;
    /// Returns t for a value between those of the ends, for an increasing segment.
    double t_of_value(double value) const;
};

/// Returns the number of the segment that contains a value, from 0 to count - 2, where the nodes
/// increase. `is_reached(i)`: node i is not above the value.
template <class Reached>
std::size_t spline_interval(std::size_t count, const Reached& is_reached) {
    std::size_t first = 0, last = count - 1;
    while (last - first > 1) {
        const std::size_t middle = (first + last) / 2;
        (is_reached(middle) ? first : last) = middle;
    }
    return first;
}

/// Returns segment number `i` of the spline with the values `f(k)`.
template <class Values>
SplineSegment spline_segment(std::span<const float> nodes, const Values& f, std::size_t i) {
    const double x0 = nodes[i], x1 = nodes[i + 1], width = x1 - x0;
    SplineSegment s{x0, width, f(i), f(i + 1), 0, 0};
    s.slope0 = i > 0 ? width * (s.f1 - f(i - 1)) / (x1 - nodes[i - 1]) : s.f1 - s.f0;
    s.slope1 = i + 2 < nodes.size() ? width * (f(i + 2) - s.f0) / (nodes[i + 2] - x0) : s.f1 - s.f0;
    return s;
}

/// A position sampled in proportion to a spline's value, and that value.
struct SplineSample {
    double x, value;
};

/// Samples a position with `u` in [0, 1). `sum(k)` is the integral up to node k.
template <class Values, class Sums>
SplineSample sample_spline(std::span<const float> nodes, const Values& f, const Sums& sum,
                           double u) {
    const double target = u * sum(nodes.size() - 1);
    const std::size_t i =
        spline_interval(nodes.size(), [&](std::size_t k) { return sum(k) <= target; });
    const SplineSegment segment = spline_segment(nodes, f, i);
    const double t = segment.t_of_integral((target - sum(i)) / segment.width);
    return {segment.begin + segment.width * t, segment.value(t)};
}

/// Weights of the nodes around a position for the spline's value there.
struct SplineWeights {
    std::size_t first;  ///< node of the second weight; the first belongs to the one before
    std::array<float, 4> weights;  ///< 0 for a node that does not exist

    /// Returns the weighted sum of `f(k)` over the nodes.
    template <class Values>
    float sum(const Values& f) const {
        float total = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            if (weights[k] != 0) total += weights[k] * f(first + k - 1);
        }
        return total;
    }
};

/// Returns the weights at x; nothing outside the nodes.
std::optional<SplineWeights> spline_weights(std::span<const float> nodes, float x);

/// Sets `sums[k]` to the integral up to node k, and returns the total.
float integrate_spline(std::span<const float> nodes, std::span<const float> values,
                       std::span<float> sums);

/// Returns the position at which a spline of increasing values has a value; the nearer end if there
/// is none.
float invert_spline(std::span<const float> nodes, std::span<const float> values, float value);

}  // namespace etalon
