#pragma once

#include "bench/scenes/shared_corners.h"

namespace etalon::bench {

/// Adds a triangle of `length` along the unit vector `direction`, with its middle near `middle`,
/// and of `width` at one end, towards a random side.
inline void add_needle(Scene& scene, const Vec3& middle, const Vec3& direction, double length,
                       double width, Random& random) {
    const Vec3 tail = middle - length / 2 * direction;
    const Vec3 side = across(direction, random.uniform(0, turn));
    add_triangle(scene, tail - width / 2 * side, tail + width / 2 * side,
                 middle + length / 2 * direction);
}

}  // namespace etalon::bench
