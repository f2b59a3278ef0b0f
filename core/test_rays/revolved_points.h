// Points of a surface of revolution, for aiming at it.
#pragma once

#include "core/numerics/random.h"
#include "core/scene/revolved.h"

namespace etalon {

/// Points in local coordinates. `off` is a factor next to 1 by which a point misses its feature.
class RevolvedPoints {
  public:
    explicit RevolvedPoints(const Revolved& s) : profile_(s.profile), sector_(s.sector) {}

    Vec3 on_surface(Random& random) const;
    Vec3 on_axis(Random& random) const;

    /// Returns a point on a rim: at the lowest or highest point of the curve, or at either radius.
    Vec3 on_rim(double off, Random& random) const;

    /// Returns a point where the sector begins or ends.
    Vec3 on_side(double off, Random& random) const;

    /// Returns a point seen edge-on from `from`; for a plane, any point of it.
    Vec3 silhouette(const Vec3& from, double off, Random& random) const;

    /// Returns whether a cone's tip is an end of the curve.
    bool has_tip() const { return is_tip(profile_.low) || is_tip(profile_.high); }
    Vec3 tip() const { return {0, 0, is_tip(profile_.low) ? profile_.low : profile_.high}; }

  private:
    bool is_tip(double z) const;

    /// Returns the point at a fraction of the curve and of the turn.
    Vec3 at(double along, double around) const;
    double radius(double z) const { return std::sqrt(std::max(0.0, profile_.square(z))); }

    Profile profile_;
    Sector sector_;
};

}  // namespace etalon
