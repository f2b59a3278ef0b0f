// The rows of shape_cases(), by kind of shape.
#pragma once

#include <numbers>

#include "tests/intersect/shape_cases.h"
#include "tests/intersect/shapes/placements.h"

namespace etalon {

inline constexpr double pi = std::numbers::pi;

/// Returns the rows of a file. A new file is declared and listed here.
using Family = std::vector<ShapeCase>();

Family sphere_cases, cone_cases, flat_cases, box_cases, plane_cases, ring_cases, quadric_cases,
    affine_cases, revolved_cases, curve_cases;

inline constexpr Family* families[] = {sphere_cases,   cone_cases, flat_cases,    box_cases,
                                       plane_cases,    ring_cases, quadric_cases, affine_cases,
                                       revolved_cases, curve_cases};

ShapeCase sphere_case(const std::string& name, const Sphere& sphere);
ShapeCase cone_case(const std::string& name, const Cone& cone);

/// Returns the case of a triangle or a polygon with these corners.
ShapeCase flat_case(const std::string& name, const std::vector<Vec3>& corners);

}  // namespace etalon
