#include "core/scene/polygon.h"

namespace etalon {
namespace {

bool is_degenerate(const PolygonPlane& plane) {
    return !is_finite(plane.normal) || !is_finite(plane.mean) || plane.normal == Vec3(0);
}

Box3 box_of(std::span<const Vec3> corners) {
    Box3 box;
    for (const Vec3& corner : corners) box.extendBy(corner);
    return box;
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
    if (!is_degenerate(plane)) box = box_of(corners);
}

}  // namespace etalon
