#pragma once

#include "core/intersect/ray.h"
#include "core/scene/scene.h"

namespace etalon {

/// Of the two points where a ray crosses a closed shape, the first visible one beyond tmin: its
/// front at `entry`, its back at `exit`.
inline double first_visible(double entry, double exit, Sides sides, double tmin) {
    if (entry > tmin && sides != Sides::back) return entry;
    if (exit > tmin && sides != Sides::front) return exit;
    return no_hit;
}

/// Whether a surface whose front normal makes `cosine` = normal . direction shows a visible side.
inline bool faces(double cosine, Sides sides) {
    return sides == Sides::both || (sides == Sides::front ? cosine < 0 : cosine > 0);
}

}  // namespace etalon
