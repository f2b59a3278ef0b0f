#pragma once

#include "core/intersect/shapes/unit_line.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Fast path for most rays: the interval of the line inside the cylinder's side, cut at the caps.
/// The heights at the two roots of the side tell which of the four points are its ends.
class ClosedCylinderFastPath {
  public:
    ClosedCylinderFastPath(const ClosedCylinder& c, const RayQuery& q)
        : line_(c.to_world.origin, c.frame, q.ray),
          tmin_(q.ray.tmin),
          across_(c.frame.length(0) + c.frame.length(1)),
          along_(c.frame.length(2)) {}

    /// Returns the first visible t beyond tmin, good to t_tolerance; no_hit; or uncertain.
    double first_hit(Sides sides) const {
        if (!line_.is_in_range(across_) || !line_.is_in_range(along_)) return uncertain;
        const Vec3 w(line_.w.x, line_.w.y, 0), d(line_.d.x, line_.d.y, 0);
        const UnitLine side(w, line_.error_of_w(across_), d, line_.error_of_d(across_));
        if (side.leaves() || side.misses()) return no_hit;
        if (side.is_parallel()) return first_between_caps(side, sides);
        if (!side.is_certain()) return uncertain;
        const LineInterval inside = side.interval();
        const CapSide entry = cap_side(inside.entry), exit = cap_side(inside.exit);
        if (entry == exit && (entry == below || entry == above)) return no_hit;
        if (entry == unknown || (entry != between && exit == unknown)) return uncertain;
        return first_ahead({end(entry, inside.entry), end(exit, inside.exit)}, sides, tmin_);
    }

  private:
    enum CapSide { below, between, above, unknown };

    /// Returns where the line's point at t is; unknown if it could be on either side of a cap.
    CapSide cap_side(const Approximate& t) const {
        const double climb = t.value * line_.d.z, z = line_.w.z + climb;
        const double e_d = line_.error_of_d(along_);
        const double e_z = line_.error_of_w(along_) + e_d * (std::abs(t.value) + t.error) +
                           t.error * std::abs(line_.d.z) + 4 * unit_roundoff;
        if (z < -e_z) return below;
        if (z > 1 + e_z) return above;
        return z > e_z && z < 1 - e_z ? between : unknown;
    }

    /// Returns the first hit of a line so nearly parallel to the axis that it is inside or outside
    /// from cap to cap.
    double first_between_caps(const UnitLine& side, Sides sides) const {
        const Approximate base = cap(0), top = cap(1);
        const double longest = std::max(base.error + std::abs(base.value),  //
                                        top.error + std::abs(top.value));
        if (!side.stays_clear(longest)) return uncertain;
        if (!side.starts_inside()) return no_hit;
        const bool rises = line_.d.z > 0;
        return first_ahead({rises ? base : top, rises ? top : base}, sides, tmin_);
    }

    /// Returns an end of the interval: the root of the side, or the cap if the root is beyond that.
    Approximate end(CapSide side, const Approximate& root) const {
        if (side == unknown) return {0, infinity};
        return side == between ? root : cap(side == below ? 0 : 1);
    }

    Approximate cap(double z) const {
        const double per_climb = 1 / line_.d.z, t = (z - line_.w.z) * per_climb;
        const double e_start = line_.error_of_w(along_) + unit_roundoff;
        const double e_d = line_.error_of_d(along_), off = e_d * std::abs(per_climb);
        const double error = 1.25 * (e_start * std::abs(per_climb) + off * std::abs(t));
        return {t, off < 0.1 ? error : infinity};
    }

    const LocalLine line_;
    const double tmin_;
    const double across_, along_;  ///< no less than the length of the rows that this depends on
};

}  // namespace etalon
