#pragma once

#include "core/intersect/ray.h"
#include "core/intersect/shapes/roots.h"
#include "core/intersect/surface.h"
#include "core/scene/scene.h"

namespace etalon {

inline bool is_degenerate(const Cone& c) {
    const double width = c.base_radius + c.top_radius;
    return !is_finite(c.base) || !is_finite(c.top) || c.base == c.top || c.base_radius < 0 ||
           c.top_radius < 0 || !(width > 0 && width < infinity);
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

/// Where a line goes into the solid cone, and where it comes out, through the lateral surface; NaN
/// where it does not.
struct ConeCrossing {
    double entry = no_hit, exit = no_hit;
};

/// A line w + t d, w seen from the base, against the surface |F + t G|^2 = r(t)^2, where h is the
/// axis, F = w x h and G = d x h are distances from the axis, and r(t) = r0 + t r1 is the radius at
/// the height start + t rise, all times |h|. Nothing refers to the apex, so a cylinder is the case
/// r1 = 0, not another formula.
struct ConeLine {
    ConeLine(const Cone& c, const Vec3& h, const Vec3& w, const Vec3& d)
        : F(w.cross(h)), G(d.cross(h)), start(w.dot(h)), rise(d.dot(h)), height(h.dot(h)) {
        const double length = std::sqrt(height);
        const double slope = (c.top_radius - c.base_radius) / length;
        r0 = length * c.base_radius + slope * start;
        r1 = slope * rise;
    }

    /// The t where distance^2 + radius^2 is least: near the axis, and near the apex, as far as the
    /// line goes there. From a point so close nothing cancels. Where that is further beyond an end
    /// than the cone is long, the t at that end.
    double middle() const {
        const double t = -(F.dot(G) + r0 * r1) / (G.dot(G) + r1 * r1);
        const double z = start + t * rise;
        if (z >= -height && z <= 2 * height) return t;
        return ((z > height ? height : 0) - start) / rise;
    }

    Vec3 F, G;
    double start, rise, height;
    double r0, r1;
};

/// Roots by the sum of like signs. Where alpha vanishes, as the line runs along a generator, one
/// root goes to infinity, and is clipped; the other is gam / sum as everywhere. Where alpha is
/// negative the line is steeper than the cone and crosses either nappe once, on opposite sides of
/// the apex: the mirror nappe is left out, and the apex is no end, so that a line through it does
/// not slip by.
inline ConeCrossing cross_cone(const Cone& c, const Ray& ray) {
    const Vec3 h = c.top - c.base, f = ray.origin - c.base;
    const double middle = ConeLine(c, h, f, ray.direction).middle();
    const ConeLine line(c, h, f + middle * ray.direction, ray.direction);
    const auto& [F, G, start, rise, height, r0, r1] = line;
    const double alpha = G.dot(G) - r1 * r1;
    const double beta = F.dot(G) - r0 * r1;
    const double gam = F.dot(F) - r0 * r0;
    const double discriminant = beta * beta - alpha * gam;
    const bool steep = alpha < 0;
    if (!(discriminant >= 0 || steep)) return {};
    // alpha t + beta, half the rise of |F + t G|^2 - r(t)^2, is -root at the entry and +root at the
    // exit.
    const double root = std::sqrt(discriminant), sum = std::abs(beta) + root;
    double entry = beta >= 0 ? -sum / alpha : gam / sum;
    double exit = beta >= 0 ? -gam / sum : sum / alpha;
    if (!(discriminant > 0)) entry = exit = -beta / alpha;  // a tangent, or through the apex

    const double lowest = steep && c.base_radius == 0 ? -infinity : 0;
    const double highest = steep && c.top_radius == 0 ? infinity : line.height;
    const auto clipped = [&](double t) {
        const double z = line.start + t * line.rise;
        return z >= lowest && z <= highest ? middle + t : no_hit;
    };
    return {steep && r1 < 0 ? no_hit : clipped(entry), steep && r1 > 0 ? no_hit : clipped(exit)};
}

inline double first_hit(const Scene&, const Cone& c, Sides sides, const RayQuery& q) {
    const ConeCrossing x = cross_cone(c, q.ray);
    const double t = first_visible(x.entry, x.exit, sides, q.ray.tmin);
    return t < infinity && !is_degenerate(c) ? t : no_hit;
}

/// The position is moved onto the circle at its height. At the apex the normal is the axis'.
inline SurfacePoint surface(const Scene&, const Cone& c, const RayQuery& q, double t) {
    const Vec3 h = c.top - c.base;
    const double length = std::sqrt(h.dot(h));
    const Vec3 w = q.ray.origin - c.base + t * q.ray.direction;
    const double along = w.dot(h) / h.dot(h), s = std::clamp(along, 0.0, 1.0);
    const double spread = c.top_radius - c.base_radius;
    const Vec3 radial = w - along * h;
    const double distance = std::sqrt(radial.dot(radial));
    const Vec3 outward = distance > 0 ? radial / distance : Vec3(0);
    Vec3 normal = length * outward - (spread / length) * h;
    normal /= std::sqrt(normal.dot(normal));
    const Vec3 position = c.base + s * h + (c.base_radius + s * spread) * outward;
    const double extent = length + std::max(c.base_radius, c.top_radius);
    return {position, position_error(abs(c.base), extent), normal, normal};
}

}  // namespace etalon
