#include "core/scene/polygon.h"

#include <algorithm>

#include "core/numerics/dyadic_vec.h"
#include "core/numerics/rounding.h"

namespace etalon {
namespace {

bool is_degenerate(const PolygonPlane& plane) {
    return !is_finite(plane.normal) || !is_finite(plane.mean) || plane.normal == Vec3(0);
}

/// Returns Newell's normal of corners so nearly collinear that its terms cancel in double.
Vec3 exact_normal(std::span<const Vec3> corners) {
    if (corners.empty() ||
        !std::ranges::all_of(corners, [](const Vec3& c) { return is_finite(c); })) {
        return Vec3(0);
    }
    DyadicVec previous = difference(corners[0], corners[0]), normal = previous;
    for (const Vec3& corner : corners.subspan(1)) {
        const DyadicVec next = difference(corner, corners[0]);
        normal = normal + cross(previous, next);
        previous = next;
    }
    return {normal[0].rounded(), normal[1].rounded(), normal[2].rounded()};
}

Box3 box_of(std::span<const Vec3> corners) {
    Box3 box;
    for (const Vec3& corner : corners) box.extendBy(corner);
    return box;
}

double largest_off_plane(std::span<const Vec3> corners, const PolygonPlane& plane,
                         const Vec3& size) {
    double largest = 0;
    for (const Vec3& corner : corners) {
        const double off = plane.normal.dot((corner - corners[0]) - plane.mean);
        largest = std::max(largest, std::abs(off));
    }
    constexpr double roundings = 16 * unit_roundoff;
    const double error = roundings * abs(plane.normal).dot(abs(plane.mean) + size);
    return largest + error + 0x1p-1000;  // products may underflow
}

OutlineProjection projection_of(std::span<const Vec3> corners, const PolygonPlane& plane,
                                const Box3& box) {
    OutlineProjection p;
    const Vec3 size = box.size();
    p.along = dominant_axis(plane.normal);
    p.scale = {1 / size[p.x_axis()], 1 / size[p.y_axis()]};
    p.off_plane = largest_off_plane(corners, plane, size);
    return p;
}

}  // namespace

PolygonPlane plane_of(std::span<const Vec3> p) {
    PolygonPlane plane;
    for (std::size_t i = 1; i < p.size(); ++i) {
        const Vec3 a = p[i - 1] - p[0], b = p[i] - p[0];
        plane.mean += b;
        plane.normal += a.cross(b);
        const Vec3 x = abs(a), y = abs(b);
        plane.terms += Vec3(x.y * y.z + x.z * y.y, x.z * y.x + x.x * y.z, x.x * y.y + x.y * y.x);
    }
    plane.mean /= static_cast<double>(p.size());
    return plane;
}

PolygonFacts::PolygonFacts(std::span<const Vec3> corners) : plane(plane_of(corners)) {
    if (plane.normal == Vec3(0)) plane.normal = exact_normal(corners);
    if (is_degenerate(plane)) return;
    box = box_of(corners);
    projection = projection_of(corners, plane, box);
}

}  // namespace etalon
