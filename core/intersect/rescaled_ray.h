#pragma once

#include <algorithm>
#include <limits>

#include "core/intersect/ray.h"
#include "core/numerics/rounding.h"

namespace etalon {

/// Products of the components of directions between 1 / this and this stay in the range of double.
inline constexpr double largest_usual_direction = 0x1p90;

/// Returns whether products of the direction's components could leave the range of double.
inline bool has_extreme_direction(const Ray& ray) {
    const double size = max_abs(ray.direction);
    return size < 1 / largest_usual_direction || size > largest_usual_direction;
}

/// A ray with its direction scaled by a power of two to usual length, which rounds nothing.
struct RescaledRay {
    explicit RescaledRay(const Ray& r)
        : ray(r), unit(power_of_two_reciprocal(max_abs(r.direction))) {
        ray.direction *= unit;
        ray.tmin /= unit;
        // A hit beyond the range of double has no t.
        ray.tmax = std::min(r.tmax, std::numeric_limits<double>::max()) / unit;
    }

    Ray ray;
    double unit;  ///< t of the original ray per t of `ray`
};

}  // namespace etalon
