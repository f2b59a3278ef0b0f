#pragma once

#include <array>

#include "bench/accuracy/textbook/kernel.h"

namespace etalon::accuracy {

template <class Real>
struct QuadricCoefficients {
    explicit QuadricCoefficients(const Quadric& s)
        : centre(s.centre), min(s.clip.min), max(s.clip.max) {
        for (std::size_t i = 0; i < m.size(); ++i) m[i] = static_cast<Real>(s.coefficients[i]);
    }

    /// Returns M v for the matrix of the squares.
    Vec<Real> turned(const Vec<Real>& v) const {
        return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[1] * v.x + m[4] * v.y + m[5] * v.z,
                m[2] * v.x + m[5] * v.y + m[7] * v.z};
    }

    /// The equation a t^2 + 2 b t + c = 0 on the line f + t d, f seen from the centre.
    struct Quadratic {
        Real a, b, c;
    };
    Quadratic of_line(const Vec<Real>& f, const Vec<Real>& d) const {
        const Vec<Real> l(m[3], m[6], m[8]), slope = turned(f) + l;
        return {d.dot(turned(d)), d.dot(slope), f.dot(slope + l) + m[9]};
    }

    /// Returns t, or NaN where the line o + t d is out of the clip box there.
    Real clipped(const Vec<Real>& o, const Vec<Real>& d, Real t) const {
        const Vec<Real> p = o + t * d;
        for (int k = 0; k < 3; ++k) {
            if (!(p[k] >= min[k] && p[k] <= max[k])) return no_root<Real>;
        }
        return t;
    }

    Vec<Real> centre, min, max;
    std::array<Real, 10> m;  ///< a, b, ... j
};

/// The quadratic formula, as in Glassner (ed.) 1989, "An Introduction to Ray Tracing", ch. 2.
template <class Real>
struct TextbookQuadric : QuadricCoefficients<Real> {
    using RayForm = PlainRay<Real>;
    using QuadricCoefficients<Real>::QuadricCoefficients;

    Real first_hit(const RayForm& ray) const {
        const auto [a, b, c] = this->of_line(ray.origin - this->centre, ray.direction);
        const Real discriminant = b * b - a * c;
        if (discriminant < 0) return no_root<Real>;
        const Real root = std::sqrt(discriminant);
        Real near = (-b - root) / a, far = (-b + root) / a;
        if (a == 0) near = far = -c / (2 * b);
        if (far < near) std::swap(near, far);
        return first_within(ray, this->clipped(ray.origin, ray.direction, near),
                            this->clipped(ray.origin, ray.direction, far));
    }
};

/// The origin moved along the ray to where it is closest to the middle of the clip box, and the
/// roots by the sum of like signs.
struct RecentredQuadric : QuadricCoefficients<float> {
    using RayForm = FloatRay;
    using QuadricCoefficients::QuadricCoefficients;

    float first_hit(const FloatRay& ray) const {
        const Vec3f& d = ray.direction;
        const float shift = (0.5F * (min + max) - ray.origin).dot(d) / d.dot(d);
        const auto [a, b, c] = of_line((ray.origin - centre) + shift * d, d);
        const float discriminant = b * b - a * c;
        if (discriminant < 0) return no_root<float>;
        const float q = -(b + std::copysign(std::sqrt(discriminant), b));
        float near = shift + c / q, far = shift + q / a;
        if (far < near) std::swap(near, far);
        return first_within(ray, clipped(ray.origin, d, near), clipped(ray.origin, d, far));
    }
};

inline auto textbook_kernels(const Scene&, const Quadric& s) {
    return std::tuple{Named{"float textbook", TextbookQuadric<float>(s)},
                      Named{"float recentred", RecentredQuadric(s)},
                      Named{"double textbook", TextbookQuadric<double>(s)}};
}

}  // namespace etalon::accuracy
