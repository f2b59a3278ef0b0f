#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/numerics/vec.h"

namespace etalon {

/// One of the two directions of a NURBS surface.
struct NurbsAxis {
    std::size_t points, order;     ///< see knots_error() in b_spline_basis.h
    std::span<const float> knots;  ///< points + order
    double begin, end;             ///< range of the surface, within that of the knots
};

/// A surface of non-uniform rational B-splines.
struct Nurbs {
    NurbsAxis u, v;
    std::span<const std::array<float, 4>> points;  ///< x, y, z and weight; u.points in a row
};

/// Points of a surface over an even grid of coordinates, row by row.
struct NurbsGrid {
    std::vector<Vec3> points, normals;      ///< normals along dpdu x dpdv, 0 where that is 0
    std::vector<std::array<float, 2>> uvs;  ///< in the units of the knots
};

/// Returns what is wrong with a surface; empty if it is valid.
std::string nurbs_error(const Nurbs& surface);

/// Evaluates a valid surface at side x side places, from end to end of its range.
NurbsGrid diced(const Nurbs& surface, std::size_t side);

}  // namespace etalon
