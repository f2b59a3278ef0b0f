// The sign that decides every edge of a triangle or polygon. It is exact, so that two faces that
// share an edge agree on which of them a ray hits: closed surfaces do not leak.
#pragma once

#include "core/intersect/ray.h"
#include "core/numerics/exact.h"
#include "core/numerics/rounding.h"

namespace etalon {

/// A corner relative to the ray: shifted to the ray's origin and sheared along its direction, so
/// that the ray is the z axis. x and y carry a factor dz.
struct ShearedCorner {
    double x, y, z;
};

inline ShearedCorner shear(const Vec3& corner, const RayQuery& q) {
    const double ax = corner[q.kx] - q.ray.origin[q.kx];
    const double ay = corner[q.ky] - q.ray.origin[q.ky];
    const double az = corner[q.kz] - q.ray.origin[q.kz];
    return {q.dz * ax - q.dx * az, q.dz * ay - q.dy * az, az};
}

/// Returns a bound on the error of a sheared coordinate, u = 2^-53: one rounding of each
/// difference, product and sum, with |dx|, |dy| <= |dz|.
inline double shear_error(double extent, double depth, const RayQuery& q) {
    return 5 * unit_roundoff * (extent + std::abs(q.dz) * depth);
}

/// Returns a bound on the error of the edge function of two corners whose sheared coordinates are
/// at most `extent` and whose depths are at most `depth` in magnitude: 4 extent E + 2 E^2 from its
/// inputs, each off by at most E = shear_error, and less than extent E from its own roundings.
inline double edge_error(double extent, double depth, const RayQuery& q) {
    const double e = shear_error(extent, depth, q);
    return e * (5 * extent + 2 * e);
}

/// Returns twice the signed area of (ray, a, b), times dz. Antisymmetric in a and b to the last
/// bit.
inline double edge_function(const ShearedCorner& a, const ShearedCorner& b) {
    return a.x * b.y - a.y * b.x;
}

/// The same with the exact sign and a relative error of at most 2^-38; slow.
inline double exact_edge_function(const Vec3& a, const Vec3& b, const RayQuery& q) {
    return q.dz * exact_edge_volume(q.ray.origin, q.ray.direction, a, b);
}

/// The same with the exact sign and an error below edge_error; less slow.
inline double exact_edge_side(const Vec3& a, const Vec3& b, const RayQuery& q) {
    return q.dz * exact_edge_sign(q.ray.origin, q.ray.direction, a, b);
}

/// A sheared corner with the exact sign of y, and also of x where y is zero.
struct OutlineCorner : ShearedCorner {
    OutlineCorner(const Vec3& p, const RayQuery& q) : ShearedCorner(shear(p, q)), corner(&p) {
        const Vec3 &o = q.ray.origin, &d = q.ray.direction;
        y = shear_sign(q.dz, p[q.ky], o[q.ky], d[q.ky], p[q.kz], o[q.kz]);
        if (y == 0) x = shear_sign(q.dz, p[q.kx], o[q.kx], d[q.kx], p[q.kz], o[q.kz]);
    }

    const Vec3* corner;
};

/// Returns the edge function with the exact sign.
inline double edge_side(const OutlineCorner& a, const OutlineCorner& b, const RayQuery& q) {
    const auto reach = [](const ShearedCorner& c) {
        return std::max(std::abs(c.x), std::abs(c.y));
    };
    const double extent = std::max(reach(a), reach(b));
    const double depth = std::max(std::abs(a.z), std::abs(b.z));
    const double side = edge_function(a, b);
    if (std::abs(side) > edge_error(extent, depth, q)) return side;
    return exact_edge_side(*a.corner, *b.corner, q);
}

}  // namespace etalon
