#pragma once

#include <vector>

#include "bench/accuracy/textbook/kernel.h"
#include "core/intersect/shapes/polygon.h"

namespace etalon::accuracy {

/// The plane first, then the crossings of the outline without the normal's dominant axis (Haines
/// 1994, "Point in Polygon Strategies", Graphics Gems IV).
template <class Real>
struct TextbookPolygon {
    using RayForm = PlainRay<Real>;

    explicit TextbookPolygon(std::span<const Vec3> p) {
        const Vec3 n = plane_of(p).normal;
        normal = Vec<Real>(normalized(n));
        distance = normal.dot(Vec<Real>(p[0]));
        const int dropped = dominant_axis(n);
        kx = (dropped + 1) % 3;
        ky = (dropped + 2) % 3;
        for (const Vec3& corner : p) {
            outline.push_back({static_cast<Real>(corner[kx]), static_cast<Real>(corner[ky])});
        }
    }

    Real first_hit(const RayForm& ray) const {
        const Real cosine = normal.dot(ray.direction);
        if (cosine == 0) return no_root<Real>;
        const Real t = (distance - normal.dot(ray.origin)) / cosine;
        if (!contains(ray, t)) return no_root<Real>;
        const Real x = ray.origin[kx] + t * ray.direction[kx];
        const Real y = ray.origin[ky] + t * ray.direction[ky];
        return covers(x, y) ? t : no_root<Real>;
    }

    bool covers(Real x, Real y) const {
        bool inside = false;
        Corner a = outline.back();
        for (const Corner& b : outline) {
            if ((a.y >= y) != (b.y >= y)) {
                const bool right = (b.y - y) * (a.x - b.x) >= (b.x - x) * (a.y - b.y);
                if (right == (b.y >= y)) inside = !inside;
            }
            a = b;
        }
        return inside;
    }

    struct Corner {
        Real x, y;
    };
    Vec<Real> normal;
    Real distance;
    int kx, ky;
    std::vector<Corner> outline;
};

inline auto textbook_kernels(const Scene&, const Polygon& p) {
    return std::tuple{Named{"float textbook", TextbookPolygon<float>(p.corners)},
                      Named{"double textbook", TextbookPolygon<double>(p.corners)}};
}

}  // namespace etalon::accuracy
