// A cone and a line in plain double. Nothing refers to the apex, so a cylinder is the case of an
// equal radius, not another formula.
#pragma once

#include "core/numerics/vec.h"
#include "core/scene/scene.h"

namespace etalon {

struct ConeAxis {
    explicit ConeAxis(const Cone& c)
        : h(c.top - c.base),
          height(h.dot(h)),
          length(std::sqrt(height)),
          slope((c.top_radius - c.base_radius) / length) {}

    Vec3 h;
    double height;  ///< w.h at the top
    double length;
    double slope;  ///< of the radius along the axis
};

/// How the direction d moves a point: G = d x h is its distance from the axis, rise its height and
/// r1 the radius there, all times |h|.
struct ConeSpeed {
    ConeSpeed(const ConeAxis& a, const Vec3& d)
        : G(d.cross(a.h)), rise(d.dot(a.h)), r1(a.slope * rise), square(G.dot(G) + r1 * r1) {}

    Vec3 G;
    double rise, r1;
    double square;  ///< |G|^2 + r1^2
};

/// Where a point w, seen from the base, is: its distance F = w x h from the axis, its height start,
/// and the radius r0 there, all times |h|.
struct ConePlace {
    ConePlace(const Cone& c, const ConeAxis& a, const Vec3& w)
        : F(w.cross(a.h)), start(w.dot(a.h)), r0(a.length * c.base_radius + a.slope * start) {}

    /// The t where distance^2 + radius^2 is least: near the axis, and near the apex, as far as the
    /// line goes there. From a point so close nothing cancels. Where that is further beyond an end
    /// than the cone is long, the t at that end.
    double middle(const ConeAxis& a, const ConeSpeed& d) const {
        const double t = -(F.dot(d.G) + r0 * d.r1) / d.square;
        const double z = start + t * d.rise;
        if (z >= -a.height && z <= 2 * a.height) return t;
        return ((z > a.height ? a.height : 0) - start) / d.rise;
    }

    Vec3 F;
    double start, r0;
};

}  // namespace etalon
