// A cone and a line in plain double. Nothing refers to the apex, so a cylinder is the special case
// of equal radii and needs no formula of its own.
#pragma once

#include "core/numerics/vec.h"
#include "core/scene/geometry.h"

namespace etalon {

struct ConeAxis {
    explicit ConeAxis(const Cone& c)
        : h(c.top - c.base),
          height(h.dot(h)),
          length(std::sqrt(height)),
          spread(c.top_radius - c.base_radius),
          slope(spread / length) {}

    Vec3 h;
    double height;  ///< w.h at the top
    double length, spread;
    double slope;  ///< slope of the radius along the axis
};

/// How the direction d moves a point: G = d x h is its distance from the axis, rise its height and
/// r1 the radius there, all times |h|.
struct ConeSpeed {
    ConeSpeed(const ConeAxis& a, const Vec3& d)
        : G(d.cross(a.h)), rise(d.dot(a.h)), r1(a.slope * rise), G2(G.dot(G)) {}

    Vec3 G;
    double rise, r1;
    double G2;
};

/// A point w, seen from the base: its distance F = w x h from the axis, its height start,
/// and the radius r0 there, all times |h|.
struct ConePoint {
    ConePoint(const Cone& c, const ConeAxis& a, const Vec3& w)
        : F(w.cross(a.h)), start(w.dot(a.h)), r0(a.length * c.base_radius + a.slope * start) {}

    Vec3 F;
    double start, r0;
};

/// Returns the t where distance^2 + radius^2 is least on the line f + t d: the point nearest to the
/// axis and the apex, from which nothing cancels. If it is further beyond an end than the cone is
/// long, returns the t at that end. The radii are r0 |h| and r1 |h|, so that no root is needed.
inline double middle(const Cone& c, const ConeAxis& a, const ConeSpeed& d, const Vec3& f) {
    const double start = f.dot(a.h);
    const double r0 = a.height * c.base_radius + a.spread * start, r1 = a.spread * d.rise;
    const double t = -(f.cross(a.h).dot(d.G) * a.height + r0 * r1) / (d.G2 * a.height + r1 * r1);
    const double z = start + t * d.rise;
    if (z >= -a.height && z <= 2 * a.height) return t;
    return ((z > a.height ? a.height : 0) - start) / d.rise;
}

}  // namespace etalon
