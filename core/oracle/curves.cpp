#include "core/intersect/shapes/curve.h"

#include "core/oracle/define.h"

namespace etalon::definition {

/// Returns what the kernel finds, since that defines a curve: the first crossing of either side
/// beyond the ray's origin.
Crossings define(const Geometry& geometry, const StoredCurve& c, const Ray& ray) {
    Crossings found;
    for (const Sides side : {Sides::front, Sides::back}) {
        const double t = first_hit(geometry, c, side, RayQuery(ray));
        const bool is_front = side == Sides::front;
        if (t < infinity) found.add({t, Certainty::yes, certainty(is_front)});
    }
    return found;
}

}  // namespace etalon::definition
