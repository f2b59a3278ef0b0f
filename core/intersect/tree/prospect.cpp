#include "core/intersect/tree/prospect.h"

#include <cmath>

#include "core/intersect/shapes/triangle.h"

namespace etalon {
namespace {

constexpr double most_cuts = 1e6;

double box_surface(const Vec3& size) {
    return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

double total_cuts(std::span<const Prospect> prospects, double factor) {
    double total = 0;
    for (const Prospect& p : prospects) total += p.cuts(factor);
    return total;
}

}  // namespace

Corners corners_of(const Scene& scene, const BoundedPrimitive& triangle) {
    return corners(scene, scene.get<Triangle>(scene.primitives[triangle.id]));
}

Box3 box_of(const Corners& corners) {
    Box3 box;
    for (const Vec3& corner : corners) box.extendBy(corner);
    return box;
}

Prospect::Prospect(const Scene& scene, const Frame& frame, const BoundedPrimitive& p)
    : surface(box_surface(Vec3(p.max - p.min))), least(surface) {
    if (p.kind != kind_of<Triangle>()) return;
    const Corners world = corners_of(scene, p);
    const Vec3 a = frame.point(world[0]), b = frame.point(world[1]), c = frame.point(world[2]);
    const Vec3 normal = abs((b - a).cross(c - a));
    least = std::min(surface, normal.x + normal.y + normal.z);
    const bool has_edges = is_finite(world[1] - world[0]) && is_finite(world[2] - world[1]) &&
                           is_finite(world[0] - world[2]);
    const auto plane = has_edges ? first_median(box_of(world), frame) : std::nullopt;
    if (plane) priority = std::cbrt(std::ldexp(surface - least, -plane->level));
}

int Prospect::cuts(double factor) const {
    return static_cast<int>(std::min(factor * priority, most_cuts));
}

double best_factor(std::span<const Prospect> prospects, double cuts, double limit) {
    if (total_cuts(prospects, limit) <= cuts) return limit;
    double high = 1;
    while (total_cuts(prospects, high) <= cuts) high *= 2;
    double low = 0;
    for (int i = 0; i < 16; ++i) {
        const double middle = (low + high) / 2;
        (total_cuts(prospects, middle) <= cuts ? low : high) = middle;
    }
    return low;
}

double gain(std::span<const Prospect> prospects, double factor) {
    double before = 0, after = 0;
    for (const Prospect& p : prospects) {
        before += p.surface;
        after += p.surface_after(p.cuts(factor));
    }
    return before > 0 ? 1 - after / before : 0;
}

}  // namespace etalon
