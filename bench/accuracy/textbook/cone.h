#pragma once

#include "bench/accuracy/textbook/kernel.h"

namespace etalon::accuracy {

/// The surface |x - z u| = r0 + k z along the unit axis u, for 0 <= z <= height. The radius is
/// given at the base, not as the distance from an apex, so that a cylinder is the case k = 0.
template <class Real>
struct ConeCoefficients {
    explicit ConeCoefficients(const Cone& c) : base(c.base) {
        const Vec<Real> h = Vec<Real>(c.top) - base;
        height = h.length();
        axis = h / height;
        radius = static_cast<Real>(c.base_radius);
        slope = (static_cast<Real>(c.top_radius) - radius) / height;
    }

    /// a t^2 + 2 b t + c = 0 where the line f + t d, relative to the base, meets the double cone.
    struct Quadratic {
        Real a, b, c, discriminant;
    };
    Quadratic of_line(const Vec<Real>& f, const Vec<Real>& d) const {
        const Real fz = f.dot(axis), dz = d.dot(axis);
        const Vec<Real> f_across = f - fz * axis, d_across = d - dz * axis;
        const Real r = radius + slope * fz, dr = slope * dz;
        const Real a = d_across.dot(d_across) - dr * dr;
        const Real b = f_across.dot(d_across) - r * dr;
        const Real c = f_across.dot(f_across) - r * r;
        return {a, b, c, b * b - a * c};
    }

    /// Returns t, or NaN if the line f + t d is beyond an end there, which also excludes the mirror
    /// nappe.
    Real clipped(const Vec<Real>& f, const Vec<Real>& d, Real t) const {
        const Real z = f.dot(axis) + t * d.dot(axis);
        return z >= 0 && z <= height ? t : no_root<Real>;
    }

    Vec<Real> base, axis;
    Real height, radius, slope;
};

/// The quadratic formula, and the height clipped. If a < 0 the far root comes first, but then one
/// of the two is on the mirror nappe.
template <class Real>
struct TextbookCone : ConeCoefficients<Real> {
    using RayForm = PlainRay<Real>;
    using ConeCoefficients<Real>::ConeCoefficients;

    Real first_hit(const RayForm& ray) const {
        const Vec<Real> f = ray.origin - this->base;
        const auto [a, b, c, discriminant] = this->of_line(f, ray.direction);
        if (discriminant < 0) return no_root<Real>;
        const Real root = std::sqrt(discriminant);
        Real near = (-b - root) / a, far = (-b + root) / a;
        if (a == 0) near = far = -c / (2 * b);  // along a generator
        return first_within(ray, this->clipped(f, ray.direction, near),
                            this->clipped(f, ray.direction, far));
    }
};

/// The origin advanced to where it is closest to the middle of the axis, as Embree does for its
/// curves, and the roots by the sum of like signs.
struct RecentredCone : ConeCoefficients<float> {
    using RayForm = FloatRay;

    explicit RecentredCone(const Cone& c)
        : ConeCoefficients(c), middle(0.5F * (Vec3f(c.base) + Vec3f(c.top))) {}

    float first_hit(const FloatRay& ray) const {
        const Vec3f& d = ray.direction;
        const float shift = (middle - ray.origin).dot(d) / d.dot(d);
        const Vec3f f = (ray.origin - base) + shift * d;
        const auto [a, b, c, discriminant] = of_line(f, d);
        if (discriminant < 0) return no_root<float>;
        const float q = -(b + std::copysign(std::sqrt(discriminant), b));
        const float s = clipped(f, d, q / a), t = clipped(f, d, c / q);
        return s < t || std::isnan(t) ? first_within(ray, shift + s, shift + t)
                                      : first_within(ray, shift + t, shift + s);
    }

    Vec3f middle;
};

inline auto textbook_kernels(const Scene&, const Cone& c) {
    return std::tuple{Named{"float textbook", TextbookCone<float>(c)},
                      Named{"float recentred", RecentredCone(c)},
                      Named{"double textbook", TextbookCone<double>(c)}};
}

}  // namespace etalon::accuracy
