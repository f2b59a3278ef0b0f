#include "core/oracle/define.h"

namespace etalon::definition {

/// Solves n . (o + t d - p) = 0, for lines that are not in the plane.
Crossings define(const Geometry&, const Plane& p, const Ray& ray) {
    Crossings found;
    if (!is_finite(p.point) || !is_finite(p.normal)) return found;
    const TrackedVec n = p.normal;
    const Tracked cosine = dot(n, ray.direction);
    const Tracked distance = dot(n, TrackedVec(p.point) - ray.origin);
    found.add({distance / cosine, !is_zero(cosine), is_negative(cosine)});
    return found;
}

/// The same with inner <= |o + t d - c| <= outer, squared, and multiplied by the divisor of t.
Crossings define(const Geometry&, const Ring& r, const Ray& ray) {
    Crossings found;
    if (!is_finite(r.centre) || !is_finite(r.normal)) return found;
    if (!(0 <= r.inner && r.inner <= r.outer && 0 < r.outer && r.outer < infinity)) return found;
    const TrackedVec n = r.normal, d = ray.direction, f = TrackedVec(ray.origin) - r.centre;
    const Tracked cosine = dot(n, d), distance = -dot(n, f);
    const auto along = [&](const Tracked& f_k, const Tracked& d_k) {
        const Tracked p = f_k * cosine + d_k * distance;
        return p * p;
    };
    const Tracked p2 = along(f.x, d.x) + along(f.y, d.y) + along(f.z, d.z);
    const auto on_circle = [&](double radius) {
        const Tracked r_times = cosine * radius;
        return r_times * r_times;
    };
    const Certainty beyond_inner = certainty(r.inner == 0) | (on_circle(r.inner) <= p2);
    const Certainty between = beyond_inner & (p2 <= on_circle(r.outer));
    const Certainty passes = !is_zero(cosine);
    found.add({distance / cosine, passes & between, is_negative(cosine)});
    return found;
}

}  // namespace etalon::definition
