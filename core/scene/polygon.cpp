#include "core/scene/polygon.h"

#include <algorithm>

#include "core/numerics/double_double.h"
#include "core/numerics/dyadic_vec.h"
#include "core/numerics/rounding.h"

namespace etalon {
namespace {

bool is_degenerate(const PolygonPlane& plane) {
    return !is_finite(plane.normal) || !is_finite(plane.mean) || plane.normal == Vec3(0);
}

/// Newell's sums over the edges seen from the first corner.
struct NewellSums {
    explicit NewellSums(std::span<const Vec3> p) {
        Vec3TwoTerm a{};
        for (const Vec3& corner : p.subspan(1)) {
            const Vec3TwoTerm b = two_differences(corner, p[0]);
            corners = corners + b;
            normal = normal + cross(a, b);
            const Vec3 x = abs(rounded(a)), y = abs(rounded(b));
            terms += {x.y * y.z + x.z * y.y, x.z * y.x + x.x * y.z, x.x * y.y + x.y * y.x};
            a = b;
        }
    }

    Vec3TwoTerm corners{};  ///< relative to the first one
    Vec3TwoTerm normal{};
    Vec3 terms{0};  ///< sums of the magnitudes of the normal's terms
};

/// Returns Newell's normal of corners so nearly collinear that its terms cancel in double-double.
Vec3 exact_normal(std::span<const Vec3> corners) {
    if (!std::ranges::all_of(corners, [](const Vec3& c) { return is_finite(c); })) return Vec3(0);
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

/// Each of the sums' terms is good to 2^-100, or to 2^-1074 where it underflows.
PolygonPlane plane_of(std::span<const Vec3> corners) {
    if (corners.empty()) return {};
    const NewellSums sums(corners);
    const auto count = static_cast<double>(corners.size());
    PolygonPlane plane{rounded(sums.corners) / count, rounded(sums.normal)};
    Vec3 of_sums = count * 0x1p-100 * sums.terms;
    if (is_finite(plane.normal) && unit_roundoff * max_abs(plane.normal) <= max_abs(of_sums)) {
        plane.normal = exact_normal(corners);
        of_sums = Vec3(0);
    }
    plane.error = 8 * unit_roundoff * abs(plane.normal) + of_sums + Vec3(0x1p-900);
    return plane;
}

PolygonFacts::PolygonFacts(std::span<const Vec3> corners) : plane(plane_of(corners)) {
    if (is_degenerate(plane)) return;
    box = box_of(corners);
    projection = projection_of(corners, plane, box);
}

}  // namespace etalon
