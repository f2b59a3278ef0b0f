#pragma once

#include <span>
#include <string>
#include <vector>

namespace etalon {

/// Returns what is wrong with the knots of a B-spline of `points` control points; empty if they are
/// valid. An order is the degree plus one, 2 or more, and there must be as many knots as points and
/// order together. Knots must not decrease, and the spline must have a positive length.
std::string knots_error(std::span<const float> knots, std::size_t order, std::size_t points);

/// The basis functions of a B-spline that are not zero at one position.
struct BSplineBasis {
    std::size_t first;                         ///< number of the first function's control point
    std::vector<double> weights, derivatives;  ///< as many as the order
};

/// Evaluates the basis functions and their derivatives at `t`, which is clamped to the range of the
/// spline (Piegl & Tiller 1997, The NURBS Book, section 2.5). At a knot they are those of the piece
/// that ends there, as in pbrt-v3, or of the first piece with a length.
BSplineBasis b_spline_basis(std::span<const float> knots, std::size_t order, double t);

}  // namespace etalon
