// Parametrizations that several shapes share. Those of a sphere, a cone and a ring are those of
// pbrt-v3 (Pharr, Jakob & Humphreys 2016, sections 3.2 to 3.5), about the z axis.
#pragma once

#include <numbers>

#include "core/intersect/parametrization.h"
#include "core/intersect/surface.h"
#include "core/numerics/affine.h"

namespace etalon {

/// Returns x clamped to [0, 1]; 0 for NaN.
inline double saturated(double x) {
    return std::min(std::max(0.0, x), 1.0);
}

/// Returns the angle about z, from +x towards +y, as a fraction of a whole turn in [0, 1].
inline double turn_fraction(const Vec3& local) {
    constexpr double turn = 2 * std::numbers::pi;
    const double phi = std::atan2(local.y, local.x);
    return (phi < 0 ? phi + turn : phi) / turn;
}

/// Returns the unit vector that points from the z axis to `local`; +x for a point of the axis.
inline Vec3 outward(const Vec3& local) {
    const double radius = std::hypot(local.x, local.y);
    return radius > 0 ? Vec3(local.x, local.y, 0) / radius : Vec3(1, 0, 0);
}

/// Returns how a point moves with the fraction of a turn about z.
inline Vec3 derivative_of_turn(const Vec3& local) {
    return 2 * std::numbers::pi * Vec3(-local.y, local.x, 0);
}

/// Returns the local coordinates of a vector under an orthonormal map. Under any map, returns those
/// of a normal up to a factor.
inline Vec3 pulled_back(const Affine& map, const Vec3& v) {
    return {map.x.dot(v), map.y.dot(v), map.z.dot(v)};
}

inline Parametrization image(const Affine& map, const Parametrization& local) {
    return {local.uv, map.vector(local.dpdu), map.vector(local.dpdv)};
}

/// Parametrizes the unit sphere: u turns about z, v grows with the angle from -z.
inline Parametrization sphere_chart(const Vec3& local) {
    constexpr double pi = std::numbers::pi;
    const double radius = std::hypot(local.x, local.y);
    return {{turn_fraction(local), std::atan2(radius, -local.z) / pi},
            derivative_of_turn(local),
            pi * (Vec3(0, 0, radius) - local.z * outward(local))};
}

/// Parametrizes the side of a cone between two circles at z = 0 and z = height: u turns about z, v
/// grows along it.
inline Parametrization cone_chart(const Vec3& outward, double v, double base_radius,
                                  double top_radius, double height) {
    const double spread = top_radius - base_radius;
    return {{turn_fraction(outward), v},
            derivative_of_turn((base_radius + v * spread) * outward),
            spread * outward + Vec3(0, 0, height)};
}

/// Parametrizes a ring in the plane z = 0: u turns about z, v grows from the outer circle to the
/// inner one.
inline Parametrization ring_chart(const Vec3& local, double inner, double outer) {
    const double width = outer - inner, radius = std::hypot(local.x, local.y);
    return {{turn_fraction(local), saturated((outer - radius) / width)},
            derivative_of_turn(local),
            -width * outward(local)};
}

/// Parametrizes a plane through the origin by lengths along two axes perpendicular to the unit
/// normal, which depend only on it. Not confined to [0, 1].
inline Parametrization plane_chart(const Vec3& normal, const Vec3& position) {
    Vec3 x, y;
    orthonormal_basis(normal, x, y);
    return {{position.dot(x), position.dot(y)}, x, y};
}

/// Parametrizes a surface in a box by its projection onto the face of the box to which the normal
/// turns most. u and v go across the face, from 0 to 1, along the two axes that follow the normal's
/// (x, y, z, x, ...); u goes backwards where the normal's component is negative.
inline Parametrization box_chart(const Box3& box, const SurfacePoint& p) {
    const int k = dominant_axis(p.normal), i = (k + 1) % 3, j = (k + 2) % 3;
    const Vec3 size = box.size(), from_min = p.position - box.min;
    const double sign = std::copysign(1.0, p.normal[k]);
    const double along_i = saturated(from_min[i] / size[i]);
    Parametrization r{
        {sign < 0 ? 1 - along_i : along_i, saturated(from_min[j] / size[j])}, Vec3(0), Vec3(0)};
    r.dpdu[i] = sign * size[i];
    r.dpdv[j] = size[j];
    // Along the tangent plane.
    r.dpdu[k] = -r.dpdu[i] * (p.normal[i] / p.normal[k]);
    r.dpdv[k] = -r.dpdv[j] * (p.normal[j] / p.normal[k]);
    return r;
}

}  // namespace etalon
