#include "core/intersect/shapes/polygon_outline.h"

#include <algorithm>

#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/intersect/shapes/polygon_outline.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Applies the even-odd rule to a point that is at most `error` inside or outside of the unit
/// square. `error`, at most 2^-6 and at least 16 u, bounds how far a corner's coordinate relative
/// to the point may be off. Such coordinates are at most 1 + 2 error in magnitude, so the side of
/// an edge is off by 4 error (1 + 2 error) + 2 error^2 and less than 8 u of roundings.
Coverage count_crossings(const OutlineColumns& columns, const Vec2& p, double error) {
    using Tag = hn::CappedTag<double, OutlineColumns::lanes>;
    const Tag tag;
    const auto x = hn::Set(tag, p.x), y = hn::Set(tag, p.y), zero = hn::Zero(tag);
    const auto y_bound = hn::Set(tag, error),
               side_bound = hn::Set(tag, OutlineBounds::of_side * error);
    auto unknown = hn::Gt(zero, zero), odd = unknown;
    for (std::size_t i = 0; i < columns.edges; i += hn::Lanes(tag)) {
        const auto ay = hn::LoadU(tag, columns.y + i) - y;
        const auto by = hn::LoadU(tag, columns.y + i + 1) - y;
        unknown = hn::Or(unknown, hn::Le(hn::Abs(by), y_bound));
        const auto ends_above = hn::Gt(by, zero);
        const auto crosses = hn::Xor(hn::Gt(ay, zero), ends_above);
        if (hn::AllFalse(tag, crosses)) continue;
        const auto ax = hn::LoadU(tag, columns.x + i) - x;
        const auto bx = hn::LoadU(tag, columns.x + i + 1) - x;
        const auto side = hn::NegMulAdd(ay, bx, ax * by);
        unknown = hn::Or(unknown, hn::And(crosses, hn::Le(hn::Abs(side), side_bound)));
        const auto passes_left = hn::Xor(hn::Gt(side, zero), ends_above);
        odd = hn::Xor(odd, hn::AndNot(passes_left, crosses));
    }
    if (!hn::AllFalse(tag, unknown)) return Coverage::unknown;
    return hn::CountTrue(tag, odd) % 2 == 1 ? Coverage::full : Coverage::none;
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(count_crossings);

bool is_edge_on(std::span<const Vec3> p, const RayQuery& q) {
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (exact_edge_function(p[i], p[(i + 1) % p.size()], q) != 0) return false;
    }
    return true;
}

/// covers() applies the even-odd rule to the outline as the ray sees it. Any projection of it along
/// the ray gives the same count, here the one into the plane through the ray's point at t that is
/// perpendicular to the stored normal, projected along an axis. In that plane a corner is moved by
/// |d| / |cosine| times its distance from it along the normal: at most off_plane plus the error of
/// the passage, which is 2^-35.8 |distance| by the bounds of plain_passage(). The point is off by
/// three roundings, and it and the corners by four more of coordinates of at most 1.
Coverage projected_coverage(const StoredPolygon& polygon, const PlanePassage& passage,
                            const RayQuery& q) {
    const OutlineProjection& projection = polygon.facts.projection;
    const Vec3& corner = polygon.facts.box.min;
    const Vec3 &o = q.ray.origin, &d = q.ray.direction;
    const double t = passage.t, cosine = std::abs(passage.cosine), along = std::abs(q.dz);
    const double moved = along * (OutlineBounds::of_passage * t +
                                  OutlineBounds::of_corners * projection.off_plane / cosine);
    const double rounded = OutlineBounds::of_point * (max_abs(o) + along * t);
    const double scale = std::max(projection.scale.x, projection.scale.y);
    const double error = (moved + rounded) * scale + OutlineBounds::of_roundings;
    if (!(error < OutlineBounds::largest_error) || cosine < OutlineBounds::least_cosine)
        return Coverage::unknown;
    const auto coordinate = [&](int axis, double axis_scale) {
        return (o[axis] + t * d[axis] - corner[axis]) * axis_scale;
    };
    const Vec2 p(coordinate(projection.x_axis(), projection.scale.x),
                 coordinate(projection.y_axis(), projection.scale.y));
    const double least = -error, most = 1 + error;
    if (p.x < least || p.x > most || p.y < least || p.y > most) return Coverage::none;
    return HWY_DYNAMIC_DISPATCH(count_crossings)(polygon.columns, p, error);
}

}  // namespace etalon
#endif
