#include "core/accel/tree/split_candidate.h"

#include <cmath>

#include "core/intersect/shapes/triangle.h"

namespace etalon {
namespace {

constexpr double most_cuts = 1e6;

double box_surface(const BoundedPrimitive& p) {
    const Vec3 size(p.max - p.min);
    return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

double total_cuts(std::span<const SplitCandidate> candidates, double factor) {
    double total = 0;
    for (const SplitCandidate& p : candidates) total += p.cuts(factor);
    return total;
}

}  // namespace

std::array<Vec3, 3> corners_of(const Geometry& geometry, const BoundedPrimitive& triangle) {
    return corners(geometry, geometry.get<Triangle>(geometry.primitives[triangle.id]));
}

SplitCandidate::SplitCandidate(const Geometry& geometry, const NormalizedSpace& space,
                               const BoundedPrimitive& p)
    : surface(box_surface(p)), least(surface) {
    if (p.kind != kind_of<Triangle>()) return;
    const auto world = corners_of(geometry, p);
    const Vec3 a = space.point(world[0]), b = space.point(world[1]), c = space.point(world[2]);
    const Vec3 normal = abs((b - a).cross(c - a));
    least = std::min(surface, normal.x + normal.y + normal.z);
    priority = std::cbrt(surface - least);
}

int SplitCandidate::cuts(double factor) const {
    return static_cast<int>(std::min(factor * priority, most_cuts));
}

/// No priority is above the cube root of the box's surface area. The smallest priority that makes a
/// cut is lowered to leave room for roundings.
bool might_be_cut(const BoundedPrimitive& p, double limit) {
    constexpr double one_cut = 0.99;
    return p.kind == kind_of<Triangle>() && box_surface(p) * limit * limit * limit > one_cut;
}

/// Rounding down removes less than one cut of each candidate, which brackets the factor.
double best_factor(std::span<const SplitCandidate> candidates, double cuts, double limit) {
    if (total_cuts(candidates, limit) <= cuts) return limit;
    double sum = 0, number = 0;
    for (const SplitCandidate& p : candidates) {
        sum += p.priority;
        number += p.priority > 0 ? 1 : 0;
    }
    double low = cuts / sum, high = (cuts + number) / sum;
    for (int i = 0; i < 12; ++i) {
        const double middle = (low + high) / 2;
        (total_cuts(candidates, middle) <= cuts ? low : high) = middle;
    }
    return low;
}

double gain(std::span<const SplitCandidate> candidates, double factor) {
    double before = 0, after = 0;
    for (const SplitCandidate& p : candidates) {
        before += p.surface;
        after += p.surface_after(p.cuts(factor));
    }
    return before > 0 ? 1 - after / before : 0;
}

}  // namespace etalon
