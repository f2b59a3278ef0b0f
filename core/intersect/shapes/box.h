#pragma once

#include "core/intersect/ray.h"
#include "core/intersect/shapes/charts.h"
#include "core/intersect/shapes/roots.h"
#include "core/intersect/surface.h"
#include "core/numerics/exact.h"
#include "core/scene/geometry.h"

namespace etalon {

inline bool is_degenerate(const Box& b) {
    return !is_finite(b.min) || !is_finite(b.max) || Box3(b.min, b.max).isEmpty();
}

inline Box3 bounds(const Geometry&, const Box& b) {
    return is_degenerate(b) ? Box3() : Box3(b.min, b.max);
}

/// Interval of a line inside all three slabs of a box, and the axes of the faces at which it enters
/// and leaves.
struct SlabCrossing {
    double entry = -infinity, exit = infinity;
    int entry_axis = 0, exit_axis = 0;
};

/// Intersects the slabs: entry > exit if the line misses the closed box by more than a few
/// roundings.
inline SlabCrossing cross_slabs(const Box& b, const Ray& ray) {
    SlabCrossing c;
    for (int k = 0; k < 3; ++k) {
        const double d = ray.direction[k], o = ray.origin[k];
        if (d == 0) {
            if (o < b.min[k] || o > b.max[k]) return {infinity, -infinity, k, k};
            continue;
        }
        // Without branches, which would not be predictable.
        const double to_min = (b.min[k] - o) / d, to_max = (b.max[k] - o) / d;
        const double near = std::min(to_min, to_max), far = std::max(to_min, to_max);
        c.entry_axis = near > c.entry ? k : c.entry_axis;
        c.exit_axis = far < c.exit ? k : c.exit_axis;
        c.entry = std::max(c.entry, near);
        c.exit = std::min(c.exit, far);
    }
    return c;
}

/// Returns whether a line that is in the slabs of the axes it runs along meets the closed box.
/// Exact.
inline bool meets_box(const Box& b, const Ray& ray) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const double di = ray.direction[i], dj = ray.direction[j];
            if (i == j || di == 0 || dj == 0) continue;
            // (near_i - o_i) / d_i <= (far_j - o_j) / d_j, times |d_i d_j|.
            const double near = (di > 0 ? b.min : b.max)[i], far = (dj > 0 ? b.max : b.min)[j];
            const double later = shear_sign(dj, near, ray.origin[i], di, far, ray.origin[j]);
            if (((di > 0) == (dj > 0) ? later : -later) > 0) return false;
        }
    }
    return true;
}

/// A difference and a quotient put entry and exit off by at most 2u each. Where they are closer
/// than that, as for a ray at an edge, the decision is exact.
inline double first_hit(const Geometry&, const Box& b, Sides sides, const RayQuery& q) {
    const SlabCrossing c = cross_slabs(b, q.ray);
    const double error_bound = 3 * unit_roundoff * (std::abs(c.entry) + std::abs(c.exit));
    if (!(c.entry - c.exit <= error_bound) || c.entry == infinity) return no_hit;
    if (is_degenerate(b) || (c.exit - c.entry <= error_bound && !meets_box(b, q.ray)))
        return no_hit;
    return first_visible(c.entry, c.exit, sides, q.ray.tmin);
}

inline SurfacePoint surface(const Geometry&, const Box& b, const RayQuery& q, double t) {
    const SlabCrossing c = cross_slabs(b, q.ray);
    const bool entering = std::abs(t - c.entry) <= std::abs(t - c.exit);
    const int axis = entering ? c.entry_axis : c.exit_axis;
    const bool at_max = (q.ray.direction[axis] > 0) != entering;
    Vec3 position = q.ray.origin + t * q.ray.direction;
    for (int k = 0; k < 3; ++k) position[k] = std::clamp(position[k], b.min[k], b.max[k]);
    position[axis] = (at_max ? b.max : b.min)[axis];
    Vec3 normal(0);
    normal[axis] = at_max ? 1 : -1;
    const Vec3 magnitude(std::max(max_abs(b.min), max_abs(b.max)));
    return {position, position_error(magnitude, 0), normal, normal};
}

/// Moves a point of a face along it, away from the box's edges by `distance` if the face is wide
/// enough. Returns whether it was moved.
inline bool move_off_edges(const Box& b, const Vec3& distance, SurfacePoint& p) {
    const Vec3 before = p.position;
    for (int k = 0; k < 3; ++k) {
        const double reach = std::min(distance[k], 0.5 * (b.max[k] - b.min[k]));
        const bool across = p.normal[k] != 0;
        if (!across) p.position[k] = std::clamp(before[k], b.min[k] + reach, b.max[k] - reach);
    }
    return p.position != before;
}

/// Parametrizes each face from 0 to 1: see box_chart(). dpdu x dpdv points outward.
inline Parametrization parametrization(const Geometry&, const Box& b, const SurfacePoint& p) {
    return box_chart({b.min, b.max}, p);
}

}  // namespace etalon
