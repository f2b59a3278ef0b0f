// Quadrics of revolution as pbrt has them: the quadratic formula in the shape's own coordinates,
// then the clips in z and phi (Pharr, Jakob & Humphreys 2016, sections 3.2 to 3.5).
#pragma once

#include <numbers>

#include "bench/accuracy/textbook/affine.h"

namespace etalon::accuracy {

template <class Real>
struct TextbookRevolved {
    using RayForm = PlainRay<Real>;

    explicit TextbookRevolved(const Revolved& s)
        : mover(s.to_world.origin, s.frame), profile(s.profile), sector(s.sector) {
        for (std::size_t i = 0; i < 3; ++i) q[i] = static_cast<Real>(s.profile.squares[i]);
        low = static_cast<Real>(s.profile.low);
        high = static_cast<Real>(s.profile.high);
    }

    Real first_hit(const RayForm& world) const {
        const RayForm ray = mover(world);
        const Vec<Real>&o = ray.origin, &d = ray.direction;
        if (profile.is_flat()) {
            const Real t = -o.z / d.z;
            return first_within(ray, clipped(o, d, t), no_root<Real>);
        }
        const Real a = d.x * d.x + d.y * d.y - q[2] * d.z * d.z;
        const Real b = o.x * d.x + o.y * d.y - (q[1] / 2 + q[2] * o.z) * d.z;
        const Real c = o.x * o.x + o.y * o.y - q[0] - (q[1] + q[2] * o.z) * o.z;
        const Real discriminant = b * b - a * c;
        if (discriminant < 0) return no_root<Real>;
        const Real root = std::sqrt(discriminant);
        Real near = (-b - root) / a, far = (-b + root) / a;
        if (a == 0) near = far = -c / (2 * b);
        if (far < near) std::swap(near, far);
        return first_within(ray, clipped(o, d, near), clipped(o, d, far));
    }

    /// Returns t, or NaN where the line is cut off there.
    Real clipped(const Vec<Real>& o, const Vec<Real>& d, Real t) const {
        const Vec<Real> p = o + t * d;
        const Real along = profile.is_flat() ? std::hypot(p.x, p.y) : p.z;
        if (!(along >= low && along <= high)) return no_root<Real>;
        if (sector.is_whole) return t;
        const Vec2 from = sector.from(p.z);
        double phi = std::atan2(from.x * p.y - from.y * p.x, from.x * p.x + from.y * p.y);
        if (phi < 0) phi += 2 * std::numbers::pi;
        return phi <= sector.angle ? t : no_root<Real>;
    }

    RayMover<RayForm> mover;
    Profile profile;
    Sector sector;
    std::array<Real, 3> q;
    Real low, high;
};

inline auto textbook_kernels(const Scene&, const Revolved& s) {
    return std::tuple{Named{"float textbook", TextbookRevolved<float>(s)},
                      Named{"double textbook", TextbookRevolved<double>(s)}};
}

}  // namespace etalon::accuracy
