// Curved shapes as polygons, for formats that do not have the shape.
#pragma once

#include <functional>
#include <span>

#include "core/scene/shapes.h"

namespace etalon {

/// Receives a convex polygon: corners, counter-clockwise from outside, and a unit normal for each;
/// none if the polygon is flat.
using FacetSink = std::function<void(std::span<const Vec3> corners, std::span<const Vec3> normals)>;

/// Makes 24 rings of 48 facets between the poles.
void to_facets(const Ellipsoid& shape, const FacetSink& take);

/// Makes 48 facets around, and two caps of 48 corners.
void to_facets(const ClosedCylinder& shape, const FacetSink& take);

/// Makes 48 facets around; the radii must be positive.
void to_facets(const Cone& shape, const FacetSink& take);

/// Makes 48 facets, facing the direction of the normal; none if the ring has no width.
void to_facets(const Ring& ring, const FacetSink& take);

}  // namespace etalon
