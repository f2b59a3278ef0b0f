#include "core/intersect/shapes/curve.h"

#include "core/intersect/shapes/curve_passage.h"
#include "core/scene/map_condition.h"

namespace etalon {
namespace {

/// Returns whether there is nothing that a ray could hit.
bool is_degenerate(const StoredCurve& c) {
    const auto is_point = [](const Vec3f& p) { return is_finite(Vec3(p)); };
    const auto is_width = [](float w) { return std::isfinite(w); };
    return !c.place.exists() || !std::ranges::all_of(c.curve.points, is_point) ||
           !std::ranges::all_of(c.curve.widths, is_width) ||
           !(widest(c.curve, c.part.begin(), c.part.end()) > 0);
}

/// Returns half of the largest width of the part.
double half_width(const StoredCurve& c) {
    return 0.5 * widest(c.curve, c.part.begin(), c.part.end());
}

/// Returns how far the map takes the points of a sphere about the origin along each world axis.
Vec3 reach_of_sphere(const Affine& m, double radius) {
    Vec3 reach;
    for (int k = 0; k < 3; ++k) {
        const Vec3 row(m.x[k], m.y[k], m.z[k]);
        const double scale = power_of_two_reciprocal(std::max(max_abs(row), 0x1p-1000));
        reach[k] = radius * std::sqrt((row * scale).dot(row * scale)) / scale;
    }
    return reach;
}

/// Returns how far from the map's image of a curve rays may hit it, since they use the inverse.
double error_of_inverse(const StoredCurve& c, const Box3& box) {
    const Affine& map = c.place.to_world;
    const double furthest = std::max(max_abs(box.min - map.origin), max_abs(box.max - map.origin));
    const double stretch = c.place.stretch;
    const double turned = stretch > ample_stretch ? 4 * stretch : 0;
    return 16 * unit_roundoff * std::max(condition_of(map, c.place.rows), turned) * furthest;
}

/// Axes of a curve where a ray passed it, in its space: dpdu x dpdv is the normal.
struct CurveAxes {
    Vec3 dpdu, normal;
};

CurveAxes axes_at(const StoredCurve& c, const CurveView& view, const CurvePassage& at) {
    Vec3 dpdu = derivative_of(points_of(c.curve), at.u);
    if (dpdu == Vec3(0)) dpdu = view.x;
    if (c.curve.type == CurveType::ribbon) {
        // dpdu x (n x dpdu)
        const Vec3 n = ribbon_normal(c.curve, at.u);
        const Vec3 normal = dpdu.dot(dpdu) * n - dpdu.dot(n) * dpdu;
        if (normal.dot(normal) > 0) return {dpdu, normalized(normal)};
    }
    const double along_x = dpdu.dot(view.x), along_y = dpdu.dot(view.y);
    Vec3 across = along_x * view.y - along_y * view.x;
    if (across == Vec3(0)) across = view.y;
    const Vec3 side = normalized(across), tangent = dpdu * power_of_two_reciprocal(max_abs(dpdu));
    const Vec3 facing = normalized(tangent.cross(side));
    if (c.curve.type != CurveType::cylinder) return {dpdu, facing};
    const double angle = (at.v - 0.5) * std::numbers::pi;
    return {dpdu, std::cos(angle) * facing + std::sin(angle) * side};
}

bool is_visible(const StoredCurve& c, const CurveView& view, const CurvePassage& at, Sides sides) {
    if (sides == Sides::both) return true;
    const bool is_front = axes_at(c, view, at).normal.dot(view.z) < 0;
    return is_front == (sides == Sides::front);
}

}  // namespace

Box3 bounds(const Geometry&, const StoredCurve& c) {
    if (is_degenerate(c)) return {};
    Box3 box;
    const CubicPoints part = part_points(c);
    for (const Vec3& p : part) box.extendBy(c.place.to_world.point(p));
    const Vec3 reach =
        reach_of_sphere(c.place.to_world, half_width(c)) + Vec3(error_of_inverse(c, box));
    return {box.min - reach, box.max + reach};
}

double first_hit(const Geometry&, const StoredCurve& c, Sides sides, const RayQuery& q) {
    const CubicPoints part = part_points(c);
    const CurveRay ray(c, part, q.ray);
    if (ray.passes_beside(part, half_width(c))) return no_hit;
    const CurveView view(ray, part);
    double nearest = infinity;
    const auto take = [&](const CurvePassage& at) {
        const bool is_nearer = at.t > q.ray.tmin && at.t < nearest;
        if (is_nearer && is_visible(c, view, at, sides)) nearest = at.t;
    };
    CurvePassages(c, part, view, take).find();
    return nearest < infinity ? nearest : no_hit;
}

SurfacePoint surface(const Geometry&, const StoredCurve& c, const RayQuery& q, double t) {
    CurvePassage at{infinity, c.part.begin(), 0.5, 0, 0, 0};
    const auto take = [&](const CurvePassage& passage) {
        if (std::abs(passage.t - t) < std::abs(at.t - t)) at = passage;
    };
    const CubicPoints part = part_points(c);
    const CurveView view(CurveRay(c, part, q.ray), part);
    CurvePassages(c, part, view, take).find();
    const CurveAxes axes = axes_at(c, view, at);
    const Vec3 centre = blossom(points_of(c.curve), at.u, at.u, at.u);
    const Vec3 local = centre - at.x * view.x - at.y * view.y;

    const Affine& m = c.place.to_world;
    const auto carried = [&](double reach) { return reach * (abs(m.x) + abs(m.y) + abs(m.z)); };
    SurfacePoint p;
    p.position = m.point(local);
    p.error = carried(2 * std::abs(width_at(c.curve, at.u))) + position_error(abs(m.origin), 0) +
              carried(64 * unit_roundoff * max_abs(abs(local) + Vec3(at.width)));
    const std::array<Vec3, 3>& rows = c.place.rows;
    const Vec3 normal = axes.normal.x * rows[0] + axes.normal.y * rows[1] + axes.normal.z * rows[2];
    p.normal = normalized(normal * power_of_two_reciprocal(max_abs(normal)));
    p.shading_normal = p.normal;
    p.on_curve = {at.u, at.v, at.width};
    return p;
}

Parametrization parametrization(const Geometry&, const StoredCurve& c, const SurfacePoint& p) {
    const Affine& m = c.place.to_world;
    const Vec3 dpdu = derivative_of(points_of(c.curve), p.on_curve.u);
    const Vec3 normal(m.x.dot(p.normal), m.y.dot(p.normal), m.z.dot(p.normal));
    const Vec3 across = normal.cross(dpdu);
    const Vec3 unit = across * power_of_two_reciprocal(max_abs(across));
    const Vec3 dpdv = p.on_curve.width * normalized(unit);
    return {{p.on_curve.u, p.on_curve.v}, m.vector(dpdu), m.vector(dpdv)};
}

}  // namespace etalon
