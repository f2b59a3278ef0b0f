#pragma once

#include "core/intersect/shapes/charts.h"
#include "core/intersect/shapes/circle.h"
#include "core/intersect/shapes/plane.h"
#include "core/numerics/transforms.h"

namespace etalon {

inline bool is_degenerate(const Ring& r) {
    const bool has_width = 0 <= r.inner && r.inner <= r.outer && 0 < r.outer && r.outer < infinity;
    return !is_finite(r.centre) || !is_finite(r.normal) || r.normal == Vec3(0) || !has_width;
}

inline Plane plane_of(const Ring& r) {
    return {r.centre, r.normal};
}

inline Box3 bounds(const Geometry&, const Ring& r) {
    if (is_degenerate(r)) return {};
    const Vec3 reach = r.outer * reach_of_circle(r.normal);
    return {r.centre - reach, r.centre + reach};
}

/// Distance from the centre at which a line passes the ring's plane, with a bound on its error.
class RingPassage {
  public:
    /// The line o + t d passes at w + t d, w = o - c; times n.d, that is n x (w x d).
    ///
    /// The error, u = 2^-53: w is off by u, and a cross or dot product adds less than 3 u of its
    /// factors. So the vector is off by less than 7 u |n| |w| |d|, and a radius times n.d by 4 u
    /// |n| |d| r: by Cauchy and Schwarz both together by 9 u size, size^2 = nn dd (ww + rr). Their
    /// squares, rounded too, differ by that times twice the longer one, and by 8 u of its square.
    RingPassage(const Ring& r, const Ray& ray) {
        const Vec3 &n = r.normal, &d = ray.direction, w = ray.origin - r.centre;
        const Vec3 passage = n.cross(w.cross(d));
        distance2_ = passage.dot(passage);
        cosine_ = n.dot(d);
        const double nn = n.dot(n), dd = d.dot(d), far2 = w.dot(w) + r.outer * r.outer;
        size2_ = nn * dd * far2;
        // Excludes relevant underflow, and overflow.
        in_range_ = std::min(std::min(nn, dd), far2) > 0x1p-250 && size2_ < 0x1p480;
    }

    /// Returns the side of a circle: 1 for outside, -1 for inside, 0 for uncertain.
    int side(double radius) const {
        constexpr double error_bound = 32 * unit_roundoff;
        const double circle2 = (radius * cosine_) * (radius * cosine_);
        const double difference = distance2_ - circle2;
        const double error_bound2 =
            error_bound * error_bound * size2_ * std::max(distance2_, circle2);
        if (!(in_range_ && error_bound2 > 0x1p-1000 && difference * difference > error_bound2))
            return 0;
        return difference > 0 ? 1 : -1;
    }

  private:
    double distance2_, cosine_, size2_;
    bool in_range_;
};

/// Returns whether the line, which is not parallel to the ring's plane, passes it between the
/// circles or on one of them. False for a degenerate ring. Slow.
[[gnu::cold]] bool is_exactly_between(const Ring& r, const Ray& ray);

/// The same, fast for most lines.
inline bool is_between(const Ring& r, const Ray& ray) {
    const RingPassage passage(r, ray);
    const int outer = passage.side(r.outer);
    if (outer > 0) return false;
    const int inner = r.inner == 0 ? 1 : passage.side(r.inner);
    if (inner < 0) return false;
    return outer < 0 && inner > 0 ? !is_degenerate(r) : is_exactly_between(r, ray);
}

/// Returns the first visible t. Hit or miss is right for every ray, and t as good as the plane's.
inline double first_hit(const Geometry& geometry, const Ring& r, Sides sides, const RayQuery& q) {
    const double t = first_hit(geometry, plane_of(r), sides, q);
    return t < infinity && is_between(r, q.ray) ? t : no_hit;
}

inline SurfacePoint surface(const Geometry& geometry, const Ring& r, const RayQuery& q, double t) {
    return surface(geometry, plane_of(r), q, t);
}

/// Returns pbrt's parametrization (of a disk), with u from the x axis of about_axis(). dpdu x dpdv
/// points where the normal does.
inline Parametrization parametrization(const Geometry&, const Ring& r, const SurfacePoint& p) {
    const Affine map = about_axis(r.centre, r.normal);
    return image(map, ring_chart(pulled_back(map, p.position - r.centre), r.inner, r.outer));
}

}  // namespace etalon
