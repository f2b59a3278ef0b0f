#include "core/intersect/shapes/ring.h"

#include "core/numerics/dyadic_vec.h"

namespace etalon {

/// Uses |(n.d) w + (n.(c - o)) d|^2, which is (n.d)^2 times the square of the distance from the
/// centre.
bool is_exactly_between(const Ring& r, const Ray& ray) {
    if (is_degenerate(r) || !is_finite(ray.origin) || !is_finite(ray.direction)) return false;
    const DyadicVec n = exactly(r.normal), d = exactly(ray.direction);
    const DyadicVec w = difference(ray.origin, r.centre);
    const Dyadic cosine2 = square(dot(n, d));
    const DyadicVec passage = cross(n, cross(w, d));
    const Dyadic distance2 = dot(passage, passage);
    return (distance2 - square(Dyadic(r.outer)) * cosine2).sign() <= 0 &&
           (distance2 - square(Dyadic(r.inner)) * cosine2).sign() >= 0;
}

}  // namespace etalon
