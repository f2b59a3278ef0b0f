#pragma once

#include "bench/accuracy/textbook/kernel.h"

namespace etalon::accuracy {

/// Intersects the plane n . x = distance, then compares the distance to the centre.
template <class Real>
struct TextbookRing {
    using RayForm = PlainRay<Real>;

    explicit TextbookRing(const Ring& r)
        : centre(r.centre),
          normal(r.normal),
          distance(normal.dot(centre)),
          inner2(static_cast<Real>(r.inner) * static_cast<Real>(r.inner)),
          outer2(static_cast<Real>(r.outer) * static_cast<Real>(r.outer)) {}

    Real first_hit(const RayForm& ray) const {
        const Real cosine = normal.dot(ray.direction);
        if (cosine == 0) return no_root<Real>;
        const Real t = (distance - normal.dot(ray.origin)) / cosine;
        const Vec<Real> p = ray.origin + t * ray.direction - centre;
        const Real radius2 = p.dot(p);
        const bool within = radius2 >= inner2 && radius2 <= outer2;
        return within && contains(ray, t) ? t : no_root<Real>;
    }

    Vec<Real> centre, normal;
    Real distance, inner2, outer2;
};

/// Ring about the origin: subtracting the centre first avoids cancellation.
struct CentredRing {
    using RayForm = FloatRay;

    explicit CentredRing(const Ring& r)
        : centre(r.centre),
          normal(r.normal),
          inner2(static_cast<float>(r.inner) * static_cast<float>(r.inner)),
          outer2(static_cast<float>(r.outer) * static_cast<float>(r.outer)) {}

    float first_hit(const FloatRay& ray) const {
        const Vec3f f = ray.origin - centre;
        const float cosine = normal.dot(ray.direction);
        if (cosine == 0) return no_root<float>;
        const float t = -normal.dot(f) / cosine;
        const Vec3f p = f + t * ray.direction;
        const float radius2 = p.dot(p);
        const bool within = radius2 >= inner2 && radius2 <= outer2;
        return within && contains(ray, t) ? t : no_root<float>;
    }

    Vec3f centre, normal;
    float inner2, outer2;
};

inline auto textbook_kernels(const Scene&, const Ring& r) {
    return std::tuple{Named{"float textbook", TextbookRing<float>(r)},
                      Named{"float from the centre", CentredRing(r)},
                      Named{"double textbook", TextbookRing<double>(r)}};
}

}  // namespace etalon::accuracy
