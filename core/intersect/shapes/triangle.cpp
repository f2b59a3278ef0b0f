#include "core/intersect/shapes/triangle.h"

namespace etalon {

void finalize_weights(TriangleCrossing& c, const TriangleCorners& p, const RayQuery& q) {
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

/// o + t d is in the plane of a, b and c, seen from o, where t d . (b x c + c x a + a x b) is
/// a . (b x c). The terms on the left are the weights but for dz, of one sign where the ray passes
/// between the corners. For a ray that has just left the triangle they are known well enough: it is
/// the volume that is next to nothing.
double exact_distance(const TriangleCrossing& c, const TriangleCorners& p, const RayQuery& q) {
    const Vec3 &o = q.ray.origin, &d = q.ray.direction;
    const double volume = exact_volume(o, p[0], p[1], p[2]);
    if (4 * c.error_bound <= t_tolerance * std::abs(c.sum)) return volume / (c.sum / q.dz);
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        sum += exact_edge_volume(o, d, p[(k + 1) % 3], p[(k + 2) % 3]);
    }
    return volume / sum;
}

}  // namespace etalon
