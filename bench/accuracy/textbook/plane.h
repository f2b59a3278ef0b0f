#pragma once

#include "bench/accuracy/textbook/kernel.h"

namespace etalon::accuracy {

/// Plane as n . x = distance: one number less than with a point, and one more cancellation.
template <class Real>
struct TextbookPlane {
    using RayForm = PlainRay<Real>;

    explicit TextbookPlane(const Plane& p)
        : normal(p.normal), distance(normal.dot(Vec<Real>(p.point))) {}

    Real first_hit(const RayForm& ray) const {
        const Real cosine = normal.dot(ray.direction);
        if (cosine == 0) return no_root<Real>;
        const Real t = (distance - normal.dot(ray.origin)) / cosine;
        return contains(ray, t) ? t : no_root<Real>;
    }

    Vec<Real> normal;
    Real distance;
};

/// Plane by a point: subtracting the point first avoids cancellation.
struct PointPlane {
    using RayForm = FloatRay;

    explicit PointPlane(const Plane& p) : point(p.point), normal(p.normal) {}

    float first_hit(const FloatRay& ray) const {
        const float cosine = normal.dot(ray.direction);
        if (cosine == 0) return no_root<float>;
        const float t = normal.dot(point - ray.origin) / cosine;
        return contains(ray, t) ? t : no_root<float>;
    }

    Vec3f point, normal;
};

inline auto textbook_kernels(const Scene&, const Plane& p) {
    return std::tuple{Named{"float textbook", TextbookPlane<float>(p)},
                      Named{"float from a point", PointPlane(p)},
                      Named{"double textbook", TextbookPlane<double>(p)}};
}

}  // namespace etalon::accuracy
