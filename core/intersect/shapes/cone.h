#pragma once

#include "core/intersect/ray.h"
#include "core/intersect/shapes/roots.h"
#include "core/intersect/surface.h"
#include "core/scene/scene.h"

namespace etalon {

inline bool is_degenerate(const Cone& c) {
    const double widest = std::max(c.base_radius, c.top_radius);
    const double least = std::min(c.base_radius, c.top_radius);
    return !is_finite(c.base) || !is_finite(c.top) || c.base == c.top || !(least >= 0) ||
           !(widest > 0) || !std::isfinite(widest);
}

/// The box of the two end circles: a circle of radius r about the axis h reaches, along the unit
/// vector e_k, r sin(h, e_k).
inline Box3 bounds(const Scene&, const Cone& c) {
    Box3 box;
    if (is_degenerate(c)) return box;
    const Vec3 h = c.top - c.base;
    const double length2 = h.dot(h);
    Vec3 reach;
    for (int k = 0; k < 3; ++k) {
        const double i = h[(k + 1) % 3], j = h[(k + 2) % 3];
        reach[k] = std::sqrt((i * i + j * j) / length2);
    }
    box.extendBy(c.base - c.base_radius * reach);
    box.extendBy(c.base + c.base_radius * reach);
    box.extendBy(c.top - c.top_radius * reach);
    box.extendBy(c.top + c.top_radius * reach);
    return box;
}

/// Where a line meets the unbounded cone: it goes in at `entry` and comes out at `exit`, each NaN
/// or infinite where there is none. On a line steeper than the cone, which stays within one nappe
/// on each side, exit < entry.
struct ConeCrossing {
    double entry = no_hit, exit = no_hit;
};

/// With h the axis vector, f the origin seen from the base and r(t) the radius at the height of the
/// ray's point, times |h|, the surface is |F + t G|^2 = r(t)^2, F = f x h, G = d x h, r = r0 + t
/// r1. Nothing refers to the apex, so a cylinder is the case r1 = 0, not another formula.
///
/// The discriminant beta^2 - alpha gam is taken in Lagrange's form |r0 G - r1 F|^2 - |F x G|^2,
/// F x G = h (f . G), whose error grows with the distance and not with its square. Where alpha
/// vanishes (the ray runs along a generator) one root goes to infinity, and is clipped; the other
/// is gam / q as everywhere.
inline ConeCrossing cross_cone(const Cone& c, const Ray& ray) {
    const Vec3 h = c.top - c.base, f = ray.origin - c.base;
    const Vec3 F = f.cross(h), G = ray.direction.cross(h);
    const double length2 = h.dot(h), length = std::sqrt(length2);
    const double slope = (c.top_radius - c.base_radius) / length;
    const double r0 = length * c.base_radius + slope * f.dot(h);
    const double r1 = slope * ray.direction.dot(h);

    const double alpha = G.dot(G) - r1 * r1;
    const double beta = F.dot(G) - r0 * r1;
    const double gam = F.dot(F) - r0 * r0;
    const Vec3 across = r0 * G - r1 * F;
    const double aside = f.dot(G);
    double discriminant = across.dot(across) - length2 * aside * aside;
    // A line steeper than the cone meets it somewhere, be it in the apex.
    if (alpha < 0) discriminant = std::max(discriminant, 0.0);
    if (!(discriminant >= 0)) return {};
    // alpha t + beta, half the rise of |F + t G|^2 - r(t)^2, is -root at the entry and +root at the
    // exit; roots by the sum of like signs.
    const double root = std::sqrt(discriminant);
    if (beta >= 0) return {(-beta - root) / alpha, gam / (-beta - root)};
    return {gam / (root - beta), (root - beta) / alpha};
}

inline double first_hit(const Scene&, const Cone& c, Sides sides, const RayQuery& q) {
    const ConeCrossing x = cross_cone(c, q.ray);
    const Vec3 h = c.top - c.base;
    const double start = (q.ray.origin - c.base).dot(h), rise = q.ray.direction.dot(h);
    const double height = h.dot(h);
    const auto is_met = [&](double t) {
        const double z = start + t * rise;
        return is_ahead(t, q.ray.tmin) && z >= 0 && z <= height;
    };
    const double entry = sides != Sides::back && is_met(x.entry) ? x.entry : infinity;
    const double exit = sides != Sides::front && is_met(x.exit) ? x.exit : infinity;
    const double t = std::min(entry, exit);
    return t < infinity && !is_degenerate(c) ? t : no_hit;
}

/// The position is moved onto the circle at its height. At the apex the normal is the axis'.
inline SurfacePoint surface(const Scene&, const Cone& c, const RayQuery& q, double t) {
    const Vec3 h = c.top - c.base;
    const double length = std::sqrt(h.dot(h));
    const Vec3 w = q.ray.origin - c.base + t * q.ray.direction;
    const double s = std::clamp(w.dot(h) / h.dot(h), 0.0, 1.0);
    const double spread = c.top_radius - c.base_radius;
    const Vec3 radial = w - s * h;
    const double distance = std::sqrt(radial.dot(radial));
    const Vec3 outward = distance > 0 ? radial / distance : Vec3(0);
    Vec3 normal = length * outward - (spread / length) * h;
    normal /= std::sqrt(normal.dot(normal));
    const Vec3 position = c.base + s * h + (c.base_radius + s * spread) * outward;
    const double extent = length + std::max(c.base_radius, c.top_radius);
    return {position, position_error(abs(c.base), extent), normal, normal};
}

}  // namespace etalon
