// What NormalizedSpace does with one ray, inline: an instance's object is entered so often that
// calls, and what they would work out twice, count.
#pragma once

#include <optional>

#include "core/intersect/normalized_space.h"

namespace etalon {

/// See NormalizedSpace::resolves().
inline bool is_resolved(const NormalizedSpace& space, const Ray& ray) {
    const double distance = max_abs(ray.origin - space.centre()) * space.scale();
    const double speed = max_abs(ray.direction) * space.scale();
    return distance < NormalizedSpace::largest_distance &&
           speed > 1 / NormalizedSpace::largest_speed && speed < NormalizedSpace::largest_speed;
}

/// See NormalizedSpace::ray().
inline std::optional<NormalizedRay> normalized_ray(const NormalizedSpace& space, const Ray& ray) {
    constexpr double largest_origin = NormalizedSpace::largest_origin;
    const double shrink = power_of_two_reciprocal(max_abs(ray.direction));
    const Vec3 direction = ray.direction * shrink;
    Vec3 origin = (ray.origin - space.centre()) * space.scale();
    double shift = 0;
    if (max_abs(origin) > largest_origin) {
        // The scene lies within sqrt(3) of normalized space's origin: start 2 before the closest
        // approach.
        const double length2 = direction.dot(direction);
        shift = -origin.dot(direction) / length2 - 2 / std::sqrt(length2);
        origin += shift * direction;
        if (max_abs(origin) > largest_origin) return std::nullopt;
    }
    const double scale = space.scale() / shrink;
    return NormalizedRay{Vec3f(origin), Vec3f(direction), shift / scale, scale};
}

}  // namespace etalon
