// One definition for each shape, as described in definitions.h.
#pragma once

#include "core/oracle/definitions.h"

namespace etalon::definition {

Crossings define(const Geometry& geometry, const Sphere& shape, const Ray& ray);
Crossings define(const Geometry& geometry, const Triangle& shape, const Ray& ray);
Crossings define(const Geometry& geometry, const Polygon& shape, const Ray& ray);
Crossings define(const Geometry& geometry, const Box& shape, const Ray& ray);
Crossings define(const Geometry& geometry, const Plane& shape, const Ray& ray);
Crossings define(const Geometry& geometry, const Cone& shape, const Ray& ray);
Crossings define(const Geometry& geometry, const Ring& shape, const Ray& ray);
Crossings define(const Geometry& geometry, const Quadric& shape, const Ray& ray);
Crossings define(const Geometry& geometry, const Ellipsoid& shape, const Ray& ray);
Crossings define(const Geometry& geometry, const ClosedCylinder& shape, const Ray& ray);
Crossings define(const Geometry& geometry, const Revolved& shape, const Ray& ray);
Crossings define(const Geometry& geometry, const StoredCurve& shape, const Ray& ray);

}  // namespace etalon::definition
