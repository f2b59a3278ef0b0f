// first_hit() of a polygon for several rays: see polygon.h and polygon_outline.cpp,
// which derives the errors. Compiled for each instruction set.
#if defined(ETALON_POLYGON_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ETALON_POLYGON_LANES_INL_H
#undef ETALON_POLYGON_LANES_INL_H
#else
#define ETALON_POLYGON_LANES_INL_H
#endif

#include "core/intersect/shapes/box_lanes-inl.h"
#include "core/intersect/shapes/polygon.h"
#include "core/intersect/shapes/ray_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// Passages of rays through a polygon's plane: see plain_passage().
struct PassageLanes {
    HWY_INLINE PassageLanes(const StoredPolygon& p, const RayLanes& rays) {
        const PolygonPlane& plane = p.facts.plane;
        const Vec3Lanes to_first = broadcast(p.corners[0]) - rays.origin;
        const Vec3Lanes normal = broadcast(plane.normal), error = broadcast(plane.error);
        cosine = normal.dot(rays.direction);
        const Doubles distance = normal.dot(to_first + broadcast(plane.mean));
        const Doubles cosine_error = error.dot(abs(rays.direction));
        const Doubles distance_error = error.dot(abs(to_first) + broadcast(p.facts.box.size()));
        const Doubles cosine_size = hn::Abs(cosine), distance_size = hn::Abs(distance);
        const Doubles zero = broadcast(0), worst = broadcast(t_tolerance / 2);
        const DoubleMask certain =
            hn::And(cosine_size > cosine_error, distance_size > distance_error);
        const DoubleMask good =
            hn::And(worst * cosine_size > cosine_error, worst * distance_size > distance_error);
        is_plain = hn::Or(good, hn::And(certain, hn::Xor(cosine > zero, distance > zero)));
        t = distance / cosine;
    }

    HWY_INLINE DoubleMask is_seen(Sides sides, const RayLanes& rays) const {
        const Doubles zero = broadcast(0);
        const DoubleMask is_beyond = t > rays.tmin;
        if (sides == Sides::both) return is_beyond;
        return hn::And(is_beyond, sides == Sides::front ? cosine < zero : cosine > zero);
    }

    Doubles t, cosine;
    DoubleMask is_plain;
};

/// Points of a polygon's plane in its projection, with bounds on their errors.
struct ProjectedLanes {
    HWY_INLINE ProjectedLanes(const PolygonFacts& facts, const PassageLanes& passage,
                              const RayLanes& rays) {
        const OutlineProjection& projection = facts.projection;
        const Vec3Lanes &o = rays.origin, &d = rays.direction;
        const Doubles along = max_abs(d.x, d.y, d.z), size = hn::Abs(passage.cosine);
        const Doubles moved =
            along * (broadcast(OutlineBounds::of_passage) * passage.t +
                     broadcast(OutlineBounds::of_corners * projection.off_plane) / size);
        const Doubles rounded =
            broadcast(OutlineBounds::of_point) * (max_abs(o.x, o.y, o.z) + along * passage.t);
        const Doubles scale = broadcast(std::max(projection.scale.x, projection.scale.y));
        error = (moved + rounded) * scale + broadcast(OutlineBounds::of_roundings);
        is_usable = hn::And(error < broadcast(OutlineBounds::largest_error),
                            size >= broadcast(OutlineBounds::least_cosine));
        const auto coordinate = [&](int axis, double axis_scale) HWY_ATTR {
            const Doubles origin = axis == 0 ? o.x : axis == 1 ? o.y : o.z;
            const Doubles direction = axis == 0 ? d.x : axis == 1 ? d.y : d.z;
            return (origin + passage.t * direction - broadcast(facts.box.min[axis])) *
                   broadcast(axis_scale);
        };
        x = coordinate(projection.x_axis(), projection.scale.x);
        y = coordinate(projection.y_axis(), projection.scale.y);
    }

    HWY_INLINE DoubleMask is_outside() const {
        const Doubles least = hn::Neg(error), most = broadcast(1) + error;
        return hn::Or(hn::Or(x<least, x> most), hn::Or(y<least, y> most));
    }

    Doubles x, y, error;
    DoubleMask is_usable;
};

struct CoverageLanes {
    DoubleMask full, unknown;
};

/// Applies the even-odd rule as count_crossings() does, to one edge after another.
HWY_INLINE CoverageLanes count_crossings(const OutlineColumns& columns, std::size_t edges,
                                         const ProjectedLanes& p) {
    const Doubles zero = broadcast(0), side_bound = broadcast(OutlineBounds::of_side) * p.error;
    DoubleMask unknown = zero > zero, full = unknown;
    Doubles ax = broadcast(columns.x[0]) - p.x, ay = broadcast(columns.y[0]) - p.y;
    DoubleMask starts_above = ay > zero;
    for (std::size_t i = 1; i <= edges; ++i) {
        const Doubles bx = broadcast(columns.x[i]) - p.x, by = broadcast(columns.y[i]) - p.y;
        const DoubleMask ends_above = by > zero, crosses = hn::Xor(starts_above, ends_above);
        unknown = hn::Or(unknown, hn::Abs(by) <= p.error);
        if (!hn::AllFalse(DoubleTag(), crosses)) {
            const Doubles side = hn::NegMulAdd(ay, bx, ax * by);
            unknown = hn::Or(unknown, hn::And(crosses, hn::Abs(side) <= side_bound));
            full = hn::Xor(full, hn::AndNot(hn::Xor(side > zero, ends_above), crosses));
        }
        ax = bx;
        ay = by;
        starts_above = ends_above;
    }
    return {full, unknown};
}

/// Returns the distances of the points kept within the box of the corners, and misses.
HWY_INLINE Doubles within_box(const Box3& box, Doubles t, const RayLanes& rays) {
    SlabCrossings c;
    c.cross(box.min.x, box.max.x, rays.origin.x, rays.direction.x);
    c.cross(box.min.y, box.max.y, rays.origin.y, rays.direction.y);
    c.cross(box.min.z, box.max.z, rays.origin.z, rays.direction.z);
    const DoubleMask is_crossed = c.exit < c.entry;
    const Doubles first = hn::IfThenElse(is_crossed, c.exit, c.entry);
    const Doubles last = hn::IfThenElse(is_crossed, c.entry, c.exit);
    const Doubles kept = hn::IfThenElse(t > first, hn::IfThenElse(last < t, last, t), first);
    return hn::IfThenElse(is_ahead(kept, rays), kept, broadcast(no_hit));
}

/// `columns` are those of the polygon, or of its SmallOutline.
HWY_INLINE HitLanes first_hits(const StoredPolygon& p, const OutlineColumns& columns, Sides sides,
                               const RayLanes& rays) {
    if (p.facts.box.isEmpty()) return misses();
    const PassageLanes passage(p, rays);
    const DoubleMask passes = passage.is_seen(sides, rays);
    const DoubleMask missed = hn::AndNot(passes, passage.is_plain);
    if (hn::AllTrue(DoubleTag(), missed)) return misses();
    const ProjectedLanes point(p.facts, passage, rays);
    const DoubleMask is_known = hn::And(passage.is_plain, point.is_usable);
    const DoubleMask is_outside = point.is_outside();
    if (hn::AllTrue(DoubleTag(), hn::Or(missed, hn::And(is_known, is_outside)))) return misses();
    const auto [full, unknown] = count_crossings(columns, p.corners.size(), point);
    const Doubles t = hn::IfThenElse(hn::AndNot(is_outside, full),
                                     within_box(p.facts.box, passage.t, rays), broadcast(no_hit));
    return hit_lanes(t, missed, hn::And(is_known, hn::Or(is_outside, hn::Not(unknown))));
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
