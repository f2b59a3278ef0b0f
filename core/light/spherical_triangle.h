#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/numerics/vec.h"

namespace etalon {

/// A triangle seen from a point: unit vectors to its corners.
struct SphericalTriangle {
    SphericalTriangle(const Vec3& to_a, const Vec3& to_b, const Vec3& to_c)
        : a(to_a), b(to_b), c(to_c) {}
    SphericalTriangle(const Vec3& from, const Vec3& p, const Vec3& q, const Vec3& r)
        : a(normalized(p - from)), b(normalized(q - from)), c(normalized(r - from)) {}

    Vec3 a, b, c;

    /// Returns the solid angle (Van Oosterom and Strackee 1983).
    double solid_angle() const {
        const double base = 1 + a.dot(b) + b.dot(c) + c.dot(a);
        return 2 * std::atan2(std::abs(a.dot(b.cross(c))), base);
    }

    /// Returns the direction at uv in a triangle of that solid angle (Arvo 1995): first a part next
    /// to a of uv.x of the solid angle, then a point of the arc from b that bounds it.
    std::optional<Vec3> direction(double solid_angle, const Vec2& uv) const {
        const Vec3 at_a_b = normalized(a.cross(b)), at_a_c = normalized(a.cross(c));
        const double cos_alpha = at_a_b.dot(at_a_c);
        const double sin_alpha = std::sqrt(std::max(0.0, 1 - cos_alpha * cos_alpha));
        // s and t: sine and cosine of pi + area - alpha, which is the sum of the part's other
        // angles.
        const double area = uv.x * solid_angle, sin_area = std::sin(area),
                     cos_area = std::cos(area);
        const double s = sin_alpha * cos_area - cos_alpha * sin_area;
        const double t = -(cos_alpha * cos_area + sin_alpha * sin_area);
        const double u = t + cos_alpha, v = s - sin_alpha * a.dot(b);
        const double q = (v + (v * t - u * s) * cos_alpha) / ((v * s + u * t) * sin_alpha);
        if (!(std::abs(q) <= 1 + 1e-6)) return std::nullopt;
        const double cos_part = std::clamp(q, -1.0, 1.0);
        const Vec3 corner = cos_part * a + std::sqrt(1 - cos_part * cos_part) * across(c, a);
        const double z = 1 - uv.y * (1 - corner.dot(b));
        const Vec3 direction = z * b + std::sqrt(std::max(0.0, 1 - z * z)) * across(corner, b);
        return is_finite(direction) ? std::optional(direction) : std::nullopt;
    }

    /// Returns the part of `v` perpendicular to the unit vector `axis`, normalized.
    static Vec3 across(const Vec3& v, const Vec3& axis) {
        return normalized(v - v.dot(axis) * axis);
    }
};

}  // namespace etalon
