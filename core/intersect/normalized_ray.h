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

/// Whether the ray's line passes the box of all that is bounded by, or leaves it before its origin:
/// by floats, whose roundings are far below NormalizedSpace::margin. Says nothing of lines that are
/// next to parallel to one of the sides.
inline bool passes_by(const NormalizedSpace& space, const NormalizedRay& ray) {
    const Vec3f reach(space.reach()), inverse = Vec3f(1) / ray.direction;
    float in = -std::numeric_limits<float>::infinity(), out = -in, largest = 0;
    for (int k = 0; k < 3; ++k) {
        const float middle = -ray.origin[k] * inverse[k], half = std::abs(inverse[k]) * reach[k];
        in = std::max(in, middle - half);
        out = std::min(out, middle + half);
        largest = std::max(largest, std::abs(inverse[k]));
    }
    return (in > out || out < 0) && largest < 0x1p60F;
}

}  // namespace etalon
