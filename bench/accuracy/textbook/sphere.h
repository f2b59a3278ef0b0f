#pragma once

#include "bench/accuracy/textbook/kernel.h"

namespace etalon::accuracy {

/// The quadratic formula with half of b, as in Glassner (ed.) 1989, "An Introduction to Ray
/// Tracing", ch. 2.
template <class Real>
struct TextbookSphere {
    using RayForm = PlainRay<Real>;

    explicit TextbookSphere(const Sphere& s)
        : centre(s.centre), radius2(static_cast<Real>(s.radius) * static_cast<Real>(s.radius)) {}

    Real first_hit(const RayForm& ray) const {
        const Vec<Real> f = ray.origin - centre;
        const Real a = ray.direction.dot(ray.direction);
        const Real b = f.dot(ray.direction);
        const Real c = f.dot(f) - radius2;
        const Real discriminant = b * b - a * c;
        if (discriminant < 0) return no_root<Real>;
        const Real root = std::sqrt(discriminant);
        return first_within(ray, (-b - root) / a, (-b + root) / a);
    }

    Vec<Real> centre;
    Real radius2;
};

/// The discriminant at the closest approach, and the root that does not cancel (Haines, Günther &
/// Akenine-Möller 2019, Ray Tracing Gems ch. 7).
struct RecentredSphere {
    using RayForm = FloatRay;

    explicit RecentredSphere(const Sphere& s)
        : centre(s.centre), radius2(static_cast<float>(s.radius) * static_cast<float>(s.radius)) {}

    float first_hit(const FloatRay& ray) const {
        const Vec3f f = ray.origin - centre;
        const float a = ray.direction.dot(ray.direction);
        const float b = -f.dot(ray.direction);
        const Vec3f approach = f + (b / a) * ray.direction;
        const float discriminant = radius2 - approach.dot(approach);
        if (discriminant < 0) return no_root<float>;
        const float c = f.dot(f) - radius2;
        const float q = b + std::copysign(std::sqrt(a * discriminant), b);
        return b >= 0 ? first_within(ray, c / q, q / a) : first_within(ray, q / a, c / q);
    }

    Vec3f centre;
    float radius2;
};

inline auto textbook_kernels(const Scene&, const Sphere& s) {
    return std::tuple{Named{"float textbook", TextbookSphere<float>(s)},
                      Named{"float RTG7", RecentredSphere(s)},
                      Named{"double textbook", TextbookSphere<double>(s)}};
}

}  // namespace etalon::accuracy
