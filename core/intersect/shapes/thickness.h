// How far away a hit may be for its point, o + t d, to say on which side of a shape it is.
#pragma once

#include "core/intersect/ray.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Return about the smallest extent on which a normal depends.
inline double thickness(const Sphere& s) {
    return s.radius;
}
inline double thickness(const Cone& c) {
    return std::max(c.base_radius, c.top_radius);
}
inline double thickness(const Quadric& q) {
    return max_abs(q.clip.max - q.clip.min);
}
inline double thickness(const LocalFrame& frame) {
    return 1 / std::max({frame.length(0), frame.length(1), frame.length(2)});
}
inline double thickness(const Ellipsoid& e) {
    return thickness(e.frame);
}
inline double thickness(const ClosedCylinder& c) {
    return thickness(c.frame);
}
inline double thickness(const Revolved& s) {
    const Profile& p = s.profile;
    if (p.is_flat()) return p.high * thickness(s.frame);
    const double height = std::max(std::abs(p.low), std::abs(p.high));
    const double widest = std::abs(p.squares[0]) +
                          height * (std::abs(p.squares[1]) + height * std::abs(p.squares[2]));
    return std::sqrt(widest) * thickness(s.frame);
}

/// A shape whose surface() needs the point o + t d next to the surface. The normals of the others
/// do not depend on it, or are as good as its place between corners.
template <class Shape>
concept HasThickness = requires(const Shape& shape) {
    { thickness(shape) } -> std::same_as<double>;
};

/// The largest distance of a hit, in units of the thickness, at which surface() is used: there the
/// roundings of o + t d are about 2^-20 of the thickness.
inline constexpr double largest_thickness_ratio = 0x1p32;

/// Returns whether a hit is further away than that.
template <HasThickness Shape>
bool is_distant(const Shape& shape, const Ray& ray, double t) {
    return max_abs(t * ray.direction) > largest_thickness_ratio * thickness(shape);
}

}  // namespace etalon
