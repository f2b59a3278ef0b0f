#include "core/intersect/shapes/triangle.h"

#include "core/numerics/dyadic_vec.h"

namespace etalon {
namespace {

/// Computes all weights in integers and divides them by one power of two. No sign changes.
void take_widest_weights(TriangleCrossing& c, const TriangleCorners& p, const RayQuery& q) {
    std::array<Dyadic, 3> volume;
    int unit = std::numeric_limits<int>::min();
    for (std::size_t k = 0; k < 3; ++k) {
        const DyadicVec from = difference(p[(k + 1) % 3], q.ray.origin);
        const DyadicVec to = difference(p[(k + 2) % 3], q.ray.origin);
        volume[k] = dot(exactly(q.ray.direction), cross(from, to));
        unit = std::max(unit, volume[k].magnitude().exponent);
    }
    const double way = q.dz < 0 ? -1 : 1;
    c.sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [mantissa, exponent] = volume[k].magnitude();
        const double size = std::max(std::ldexp(mantissa, exponent - unit), 0x1p-900);
        c.sum += c.weight[k] = way * volume[k].sign() * size;
    }
}

/// Returns the distance at which the ray passes the plane, computed in integers.
double widest_distance(const TriangleCorners& p, const RayQuery& q) {
    const DyadicVec n = cross(difference(p[1], p[0]), difference(p[2], p[0]));
    const Dyadic distance = dot(n, difference(p[0], q.ray.origin));
    const Dyadic cosine = dot(n, exactly(q.ray.direction));
    const WideDouble t = distance.magnitude() / cosine.magnitude();
    return distance.sign() * cosine.sign() * static_cast<double>(t);
}

bool are_finite(const TriangleCorners& p, const Ray& ray) {
    return is_finite(p[0]) && is_finite(p[1]) && is_finite(p[2]) && is_finite(ray.origin) &&
           is_finite(ray.direction);
}

}  // namespace

void finalize_weights(TriangleCrossing& c, const TriangleCorners& p, const RayQuery& q) {
    if (!c.is_in_range()) {
        if (are_finite(p, q.ray)) take_widest_weights(c, p, q);
        return;
    }
    const bool thin = is_thin(c);
    for (int k = 0; k < 3; ++k) {
        if (!thin && std::abs(c.weight[k]) > c.error_bound) continue;
        const Vec3 &from = p[(k + 1) % 3], &to = p[(k + 2) % 3];
        c.weight[k] = thin ? exact_edge_function(from, to, q) : exact_edge_side(from, to, q);
    }
    const auto [u, v, w] = c.weight;
    c.sum = u + v + w;
    if (thin) c.error_bound = 0x1p-38 * max_abs(u, v, w);
}

/// o + t d is in the plane of a, b and c, seen from o, where t d . (b x c + c x a + a x b) is a .
/// (b x c). The terms on the left are the weights but for dz, and of one sign where the ray passes
/// between the corners. For a ray that has just left the triangle they are accurate enough; it is
/// the volume that nearly vanishes.
double exact_distance(const TriangleCrossing& c, const TriangleCorners& p, const RayQuery& q) {
    const Vec3 &o = q.ray.origin, &d = q.ray.direction;
    const double volume = exact_volume(o, p[0], p[1], p[2]);
    // Next to the plane the volume may leave the range of double where the weights do not.
    if (!c.is_in_range() || std::isnan(volume)) {
        return are_finite(p, q.ray) ? widest_distance(p, q) : no_hit;
    }
    if (4 * c.error_bound <= t_tolerance * std::abs(c.sum)) return volume / (c.sum / q.dz);
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        sum += exact_edge_volume(o, d, p[(k + 1) % 3], p[(k + 2) % 3]);
    }
    return volume / sum;
}

}  // namespace etalon
