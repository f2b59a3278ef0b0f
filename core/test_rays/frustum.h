// The geometry of a cone or cylinder, for aiming at it.
#pragma once

#include "core/scene/shapes.h"
#include "core/test_rays/directions.h"

namespace etalon {

class Frustum {
  public:
    explicit Frustum(const Cone& cone) : cone_(cone), length_((cone.top - cone.base).length()) {
        axis_ = (cone.top - cone.base) / length_;
        orthonormal_basis(axis_, u_, v_);
    }

    const Cone& cone() const { return cone_; }
    const Vec3& axis() const { return axis_; }  ///< of unit length, from the base to the top
    double length() const { return length_; }
    double spread() const { return cone_.top_radius - cone_.base_radius; }
    double radius(double s) const { return cone_.base_radius + s * spread(); }

    /// Returns a unit vector at `angle` about the axis.
    Vec3 side(double angle) const { return std::cos(angle) * u_ + std::sin(angle) * v_; }

    /// Returns the point at the fraction `s` of the axis, `reach` radii from it.
    Vec3 point(double s, double reach, double angle) const {
        return cone_.base + s * length_ * axis_ + reach * radius(s) * side(angle);
    }

    /// Returns the outward unit normal at the angle.
    Vec3 normal(double angle) const {
        return (length_ * side(angle) - spread() * axis_).normalized();
    }

    /// Returns a point of the surface at the fraction `s` that is seen edge-on from `from`, or the
    /// nearest to that. There outward . f = r + (spread / length) (f . axis), f from the axis's
    /// point at s.
    Vec3 silhouette(double s, double reach, const Vec3& from, double which_side) const {
        const Vec3 f = from - (cone_.base + s * length_ * axis_);
        const double x = f.dot(u_), y = f.dot(v_);
        const double needed = radius(s) + spread() * f.dot(axis_) / length_;
        const double opening = std::acos(std::clamp(needed / std::hypot(x, y), -1.0, 1.0));
        return point(s, reach, std::atan2(y, x) + which_side * opening);
    }

  private:
    Cone cone_;
    double length_;
    Vec3 axis_, u_, v_;
};

}  // namespace etalon
