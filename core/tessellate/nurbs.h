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
    double begin, end;             ///< the part of the surface, within that of the knots
};

/// A surface of non-uniform rational B-splines.
struct Nurbs {
    NurbsAxis u, v;
    std::span<const std::array<float, 4>> points;  ///< x, y, z and weight; u.points a row
};

/// Points of a surface over an even grid of coordinates, row by row.
struct NurbsGrid {
    std::vector<Vec3> points, normals;      ///< normals along dpdu x dpdv, 0 where that is 0
    std::vector<std::array<float, 2>> uvs;  ///< in the units of the knots
};

/// What is wrong with a surface; empty if nothing is.
std::string nurbs_error(const Nurbs& surface);

/// Evaluates a surface without errors at side x side places, from end to end of its part.
NurbsGrid diced(const Nurbs& surface, std::size_t side);

}  // namespace etalon
