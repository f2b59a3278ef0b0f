#include "core/oracle/define.h"

#include <algorithm>
#include <utility>

#include "core/oracle/line_interval.h"
#include "core/oracle/mapped_ray.h"
#include "core/oracle/quadratic.h"

namespace etalon::definition {
namespace {

/// Distance greater than that between any two points with double coordinates.
const Tracked beyond(Quad(0x1p1023) * Quad(0x1p1023), 0);

/// Returns the interval of a line where a t^2 + 2 b t + c <= 0, for a >= 0.
LineInterval where_not_positive(const Tracked& a, const Tracked& b, const Tracked& c) {
    LineInterval interval{-beyond, beyond, Certainty::yes};
    if ((is_zero(a) & is_zero(b)) == Certainty::yes) {
        interval.exists = !is_positive(c);
        return interval;
    }
    const Roots roots = solve(a, b, c);
    if (roots.count == 0) interval.exists = Certainty::no;
    for (std::size_t i = 0; i < roots.count; ++i) {
        const Root& root = roots.list[i];
        interval.exists = interval.exists & root.exists;
        if (root.falling != Certainty::no) interval.entry = root.t;
        if (root.falling != Certainty::yes) interval.exit = root.t;
    }
    return interval;
}

/// Returns the interval of a line where 0 <= start + t rise <= top, for top > 0.
LineInterval where_between(const Tracked& start, const Tracked& rise, const Tracked& top) {
    if (is_zero(rise) == Certainty::yes) {
        return {-beyond, beyond, (!is_negative(start)) & (start <= top)};
    }
    const Tracked low = -start / rise, high = (top - start) / rise;
    if (rise.value > 0) return {low, high, Certainty::yes};
    return {high, low, Certainty::yes};
}

/// Returns the greater of two numbers. Where their bounds overlap, it has those of either.
Tracked greater(const Tracked& a, const Tracked& b) {
    if ((a < b) == Certainty::yes) return b;
    if ((b < a) == Certainty::yes) return a;
    const Quad low = std::max(a.value - a.error, b.value - b.error);
    const Quad high = std::max(a.value + a.error, b.value + b.error);
    if (!(high - low < Quad(infinity))) return {0, Quad(infinity)};
    const Quad rounding = 2 * std::max(magnitude(low), magnitude(high)) * quad_roundoff;
    return detail::bounded((low + high) / 2, (high - low) / 2 + rounding);
}

LineInterval both(const LineInterval& a, const LineInterval& b) {
    return {greater(a.entry, b.entry), -greater(-a.exit, -b.exit),
            a.exists & b.exists & !(a.exit < b.entry) & !(b.exit < a.entry)};
}

}  // namespace

Crossings define(const Geometry&, const Box& b, const Ray& ray) {
    if (!is_finite(b.min) || !is_finite(b.max)) return {};
    return ends(within_box(b.min, b.max, ray));
}

/// Intersects x^2 + y^2 <= 1 and 0 <= z <= 1 in the map's coordinates.
Crossings define(const Geometry&, const ClosedCylinder& c, const Ray& ray) {
    if (!is_finite(c.to_world)) return {};
    const MappedRay r(c.to_world, ray);
    const Certainty exists = !is_zero(r.unit);
    if (exists == Certainty::no) return {};
    const TrackedVec &o = r.origin, &d = r.direction;
    const Tracked square = r.unit * r.unit;
    const LineInterval side = where_not_positive(d.x * d.x + d.y * d.y, o.x * d.x + o.y * d.y,
                                                 o.x * o.x + o.y * o.y - square);
    LineInterval solid = both(side, where_between(o.z * r.unit, d.z * r.unit, square));
    solid.exists = solid.exists & exists;
    return ends(solid);
}

}  // namespace etalon::definition
