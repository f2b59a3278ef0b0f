#pragma once

#include "core/intersect/ray.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Value that a fast path returns instead of a t that its error bound cannot guarantee.
inline constexpr double uncertain = -infinity;

/// Returns whether a root counts: beyond tmin, and not carried to infinity by a vanishing
/// denominator.
inline bool is_ahead(double t, double tmin) {
    return t > tmin && t < infinity;
}

/// Points where a line enters a solid and where it leaves it; NaN where it does not.
struct Passage {
    double entry = no_hit, exit = no_hit;
};

/// Returns the first visible point beyond tmin of the two where a ray crosses a closed shape: its
/// front at `entry`, its back at `exit`.
inline double first_visible(double entry, double exit, Sides sides, double tmin) {
    if (is_ahead(entry, tmin) && sides != Sides::back) return entry;
    if (is_ahead(exit, tmin) && sides != Sides::front) return exit;
    return no_hit;
}

/// Returns whether a surface whose front normal makes `cosine` = normal . direction shows a visible
/// side.
inline bool faces(double cosine, Sides sides) {
    return sides == Sides::both || (sides == Sides::front ? cosine < 0 : cosine > 0);
}

}  // namespace etalon
