#include "core/oracle/define.h"

#include "core/oracle/mapped_ray.h"
#include "core/oracle/quadratic.h"

namespace etalon::definition {

/// Solves |o + t d - c| = r. The front is hit where the distance decreases.
Crossings define(const Geometry&, const Sphere& s, const Ray& ray) {
    Crossings found;
    if (!(s.radius > 0) || !std::isfinite(s.radius) || !is_finite(s.centre)) return found;
    const TrackedVec d = ray.direction, f = TrackedVec(ray.origin) - s.centre;
    const Tracked r = s.radius;
    const Roots roots = solve(dot(d, d), dot(f, d), dot(f, f) - r * r);
    for (std::size_t i = 0; i < roots.count; ++i) {
        const Root& root = roots.list[i];
        found.add({root.t, root.exists, root.falling});
    }
    return found;
}

/// Points w from the base, with h the axis, at distance r0 + (r1 - r0) z from the line along h at
/// the height z = w.h / h.h, 0 <= z <= 1. Squared and freed of roots and quotients: hh |w x h|^2 =
/// (hh r0 + (r1 - r0) wh)^2. As hh ww - (wh)^2 the product would cancel next to a long axis.
Crossings define(const Geometry&, const Cone& c, const Ray& ray) {
    Crossings found;
    if (!is_finite(c.base) || !is_finite(c.top) || c.base == c.top) return found;
    for (const double r : {c.base_radius, c.top_radius}) {
        if (!(r >= 0) || !std::isfinite(r)) return found;
    }
    if (c.base_radius == 0 && c.top_radius == 0) return found;

    const TrackedVec h = TrackedVec(c.top) - c.base, d = ray.direction;
    const TrackedVec f = TrackedVec(ray.origin) - c.base;
    const Tracked spread = Tracked(c.top_radius) - c.base_radius;
    const Tracked hh = dot(h, h), fh = dot(f, h), dh = dot(d, h);
    const Tracked r0 = hh * c.base_radius + spread * fh, r1 = spread * dh;
    const TrackedVec fxh = cross(f, h), dxh = cross(d, h);
    const Roots roots = solve(hh * dot(dxh, dxh) - r1 * r1, hh * dot(fxh, dxh) - r0 * r1,
                              hh * dot(fxh, fxh) - r0 * r0);
    for (std::size_t i = 0; i < roots.count; ++i) {
        const Root& root = roots.list[i];
        const Tracked z = fh + root.t * dh;
        const Certainty within = (z <= hh) & !is_negative(z);
        found.add({root.t, root.exists & within, root.falling});
    }
    return found;
}

namespace {

/// Returns whether the root t is at a face of the box or within: by o + t d or, if that cannot be
/// decided, because the form a t^2 + 2 b t + c is known to vanish at the face, and not by the other
/// root.
Certainty is_within(const Box3& box, const Ray& ray, const Tracked& t, const Tracked* other,
                    const Tracked& a, const Tracked& b, const Tracked& c) {
    Certainty within = Certainty::yes;
    for (int k = 0; k < 3; ++k) {
        const Tracked o = ray.origin[k], d = ray.direction[k], p = o + t * d;
        const auto is_at = [&](double face) {
            const Tracked w = Tracked(face) - o;
            const Certainty is_other = other == nullptr ? Certainty::no : is_zero(w - *other * d);
            return is_zero(a * w * w + 2 * (b * w * d) + c * d * d) & !is_zero(d) & !is_other;
        };
        const auto is_not_beyond = [&](Certainty inside, double face) {
            return inside == Certainty::unknown ? inside | is_at(face) : inside;
        };
        within = within & is_not_beyond(Tracked(box.min[k]) <= p, box.min[k]) &
                 is_not_beyond(p <= Tracked(box.max[k]), box.max[k]);
    }
    return within;
}

}  // namespace

/// Returns the symmetric matrix of the coefficients, row by row, for (p - centre, 1).
Crossings define(const Geometry&, const Quadric& s, const Ray& ray) {
    Crossings found;
    if (!is_finite(s.centre) || !is_finite(s.clip.min) || !is_finite(s.clip.max)) return found;
    for (const double number : s.coefficients) {
        if (!std::isfinite(number)) return found;
    }
    if (s.clip.isEmpty()) return found;
    const TrackedVec w = TrackedVec(ray.origin) - s.centre, d = ray.direction;
    const auto polar = [&](const std::array<Tracked, 4>& x, const std::array<Tracked, 4>& y) {
        Tracked sum;
        std::size_t next = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            sum = sum + s.coefficients[next++] * (x[i] * y[i]);
            for (std::size_t j = i + 1; j < 4; ++j) {
                sum = sum + s.coefficients[next++] * (x[i] * y[j] + x[j] * y[i]);
            }
        }
        return sum;
    };
    const std::array<Tracked, 4> x = {w.x, w.y, w.z, 1}, y = {d.x, d.y, d.z, 0};
    const Tracked a = polar(y, y), b = polar(x, y), c = polar(x, x);
    const Roots roots = solve(a, b, c);
    for (std::size_t i = 0; i < roots.count; ++i) {
        const Root& root = roots.list[i];
        const Tracked* const other = roots.count == 2 ? &roots.list[1 - i].t : nullptr;
        const Certainty within = is_within(s.clip, ray, root.t, other, a, b, c);
        found.add({root.t, root.exists & within, root.falling});
    }
    return found;
}

/// Solves |o + t d| = 1 in the map's coordinates.
Crossings define(const Geometry&, const Ellipsoid& e, const Ray& ray) {
    Crossings found;
    if (!is_finite(e.to_world)) return found;
    const MappedRay r(e.to_world, ray);
    const Certainty exists = !is_zero(r.unit);
    if (exists == Certainty::no) return found;
    const TrackedVec &o = r.origin, &d = r.direction;
    const Roots roots = solve(dot(d, d), dot(o, d), dot(o, o) - r.unit * r.unit);
    for (std::size_t i = 0; i < roots.count; ++i) {
        const Root& root = roots.list[i];
        found.add({root.t, exists & root.exists, root.falling});
    }
    return found;
}

}  // namespace etalon::definition
