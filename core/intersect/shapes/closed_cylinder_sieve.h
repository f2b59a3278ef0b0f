#pragma once

#include "core/intersect/shapes/local_line.h"
#include "core/scene/scene.h"

namespace etalon {

/// Where most rays meet a closed cylinder: the line's stretch inside its side, cut off at the caps.
/// Which of the four points are its ends is told by the height at the two roots of the side.
class ClosedCylinderSieve {
  public:
    ClosedCylinderSieve(const ClosedCylinder& c, const RayQuery& q)
        : line_(c.to_world, c.to_local, q.ray),
          tmin_(q.ray.tmin),
          across_(c.to_local.lengths.x + c.to_local.lengths.y),
          along_(c.to_local.lengths.z) {}

    /// The first visible t beyond tmin, good to t_tolerance; no_hit; or in_doubt.
    double first_hit(Sides sides) const {
        if (!line_.is_in_range(across_) || !line_.is_in_range(along_)) return in_doubt;
        const Vec3 w(line_.w.x, line_.w.y, 0), d(line_.d.x, line_.d.y, 0);
        const UnitLine side(w, line_.error_of_w(across_), d, line_.error_of_d(across_));
        if (side.leaves() || side.misses()) return no_hit;
        if (!side.is_certain()) return in_doubt;
        const UnitLine::Roots roots = side.roots();
        const Place entry = place(roots.entry), exit = place(roots.exit);
        if (entry == exit && (entry == below || entry == above)) return no_hit;
        if (entry == unknown || (entry != between && exit == unknown)) return in_doubt;
        const double t = sides == Sides::back ? no_hit : ahead(end(entry, roots.entry), tmin_);
        if (t <= infinity || sides == Sides::front) return t;
        return exit == unknown ? in_doubt : ahead(end(exit, roots.exit), tmin_);
    }

  private:
    enum Place { below, between, above, unknown };

    /// Of the line at t; between the caps, or surely not.
    Place place(const Approximate& t) const {
        const double climb = t.value * line_.d.z, z = line_.w.z + climb;
        const double e_d = line_.error_of_d(along_);
        const double e_z = line_.error_of_w(along_) + e_d * (std::abs(t.value) + t.error) +
                           t.error * std::abs(line_.d.z) + 4 * unit_roundoff;
        if (z < -e_z) return below;
        if (z > 1 + e_z) return above;
        return z > e_z && z < 1 - e_z ? between : unknown;
    }

    /// Where the stretch ends, of whose side's end the place is known.
    Approximate end(Place place, const Approximate& root) const {
        return place == between ? root : cap(place == below ? 0 : 1);
    }

    Approximate cap(double z) const {
        const double speed = std::abs(line_.d.z), e_d = line_.error_of_d(along_);
        const double t = (z - line_.w.z) / line_.d.z;
        const double e_start = line_.error_of_w(along_) + unit_roundoff;
        const double error = 1.25 * (e_start + std::abs(t) * e_d) / speed;
        return {t, e_d < 0.1 * speed ? error : infinity};
    }

    const LocalLine line_;
    const double tmin_;
    const double across_, along_;  ///< no less than the length of the rows that this depends on
};

}  // namespace etalon
