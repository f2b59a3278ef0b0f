#pragma once

#include <algorithm>
#include <limits>

#include "core/intersect/ray.h"
#include "core/numerics/rounding.h"

namespace etalon {

/// Directions between the reciprocal of this and this have products that are doubles.
inline constexpr double largest_usual_direction = 0x1p90;

/// Returns whether products of the direction's components could leave the range of double.
inline bool has_extreme_direction(const Ray& ray) {
    const double size = max_abs(ray.direction);
    return size < 1 / largest_usual_direction || size > largest_usual_direction;
}

/// A ray with a direction of usual length in place of one that is extreme: by a power of two, which
/// rounds nothing.
struct RescaledRay {
    explicit RescaledRay(const Ray& r)
        : ray(r), unit(power_of_two_reciprocal(max_abs(r.direction))) {
        ray.direction *= unit;
        ray.tmin /= unit;
        // What is hit beyond the range of double has no t.
        ray.tmax = std::min(r.tmax, std::numeric_limits<double>::max()) / unit;
    }

    Ray ray;
    double unit;  ///< of the ray's t, in that of the one it stands for
};

}  // namespace etalon
