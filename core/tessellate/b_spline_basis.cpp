#include "core/tessellate/b_spline_basis.h"

#include <fmt/format.h>

#include <algorithm>

namespace etalon {

std::string knots_error(std::span<const float> knots, std::size_t order, std::size_t points) {
    if (order < 2) return fmt::format("its order is 2 or more, not {}", order);
    if (points < order) {
        return fmt::format("a spline of order {} has {} points or more, not {}", order, order,
                           points);
    }
    if (knots.size() != points + order) {
        return fmt::format("{} points of order {} have {} knots, not {}", points, order,
                           points + order, knots.size());
    }
    if (!std::ranges::is_sorted(knots)) return "its knots decrease";
    if (!(knots[order - 1] < knots[points])) return "its knots are all in one place";
    return {};
}

namespace {

/// Returns the number of the knot before the piece that contains `t` and has a length.
std::size_t piece_at(std::span<const float> knots, std::size_t order, double t) {
    const std::size_t last = knots.size() - order - 1;
    std::size_t piece = order - 1;
    while (piece < last && t > knots[piece + 1]) ++piece;
    while (piece < last && knots[piece] == knots[piece + 1]) ++piece;
    while (knots[piece] == knots[piece + 1]) --piece;
    return piece;
}

/// Replaces the values of the functions of one degree by those of the next, in place.
void raise_degree(std::span<const float> knots, std::size_t piece, double t,
                  std::vector<double>& values) {
    const std::size_t degree = values.size();
    values.push_back(0);
    double saved = 0;
    for (std::size_t r = 0; r < degree; ++r) {
        const double right = knots[piece + r + 1], left = knots[piece + 1 + r - degree];
        const double part = values[r] / (right - left);
        values[r] = saved + (right - t) * part;
        saved = (t - left) * part;
    }
    values[degree] = saved;
}

/// Computes the derivatives from the values of one degree less.
std::vector<double> derivatives_from(std::span<const float> knots, std::size_t piece,
                                     const std::vector<double>& values) {
    const std::size_t degree = values.size();
    std::vector<double> derivatives(degree + 1, 0.0);
    for (std::size_t r = 0; r < degree; ++r) {
        const double span = double{knots[piece + r + 1]} - knots[piece + 1 + r - degree];
        const double slope = static_cast<double>(degree) * values[r] / span;
        derivatives[r] -= slope;
        derivatives[r + 1] += slope;
    }
    return derivatives;
}

}  // namespace

BSplineBasis b_spline_basis(std::span<const float> knots, std::size_t order, double t) {
    t = std::clamp<double>(t, knots[order - 1], knots[knots.size() - order]);
    const std::size_t piece = piece_at(knots, order, t);
    std::vector<double> values{1};
    while (values.size() + 1 < order) raise_degree(knots, piece, t, values);
    std::vector<double> derivatives = derivatives_from(knots, piece, values);
    raise_degree(knots, piece, t, values);
    return {piece + 1 - order, std::move(values), std::move(derivatives)};
}

}  // namespace etalon
