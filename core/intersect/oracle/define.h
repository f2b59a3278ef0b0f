// One definition for each shape, of what is said of all in definitions.h.
#pragma once

#include "core/intersect/oracle/definitions.h"

namespace etalon::definition {

Crossings define(const Scene& scene, const Sphere& shape, const Ray& ray);
Crossings define(const Scene& scene, const Triangle& shape, const Ray& ray);
Crossings define(const Scene& scene, const Polygon& shape, const Ray& ray);
Crossings define(const Scene& scene, const Box& shape, const Ray& ray);
Crossings define(const Scene& scene, const Plane& shape, const Ray& ray);
Crossings define(const Scene& scene, const Cone& shape, const Ray& ray);
Crossings define(const Scene& scene, const Ring& shape, const Ray& ray);
Crossings define(const Scene& scene, const Quadric& shape, const Ray& ray);
Crossings define(const Scene& scene, const Ellipsoid& shape, const Ray& ray);
Crossings define(const Scene& scene, const ClosedCylinder& shape, const Ray& ray);

}  // namespace etalon::definition
