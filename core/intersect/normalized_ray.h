// NormalizedSpace's operations on one ray, inline: rays enter the objects of instances so often
// that calls, and values computed twice, would show.
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

/// Additional data with which float slab tests are as accurate as the ray's doubles.
struct FineRay {
    Vec3f rest;   ///< the exact origin minus the float origin, in normalized space
    float slack;  ///< how far a hit may be outside of its box, if that has least_padding
};

/// The slack covers the roundings of coordinates in double. If the ray comes from further away, it
/// also covers how far they move hits on instances (see instance_bounds()), with ample room.
inline FineRay fine_ray(const NormalizedSpace& space, double spread, const Ray& ray,
                        const NormalizedRay& local) {
    const Vec3 direction = ray.direction * power_of_two_reciprocal(max_abs(ray.direction));
    const double shift = local.shift * local.scale;
    const Vec3 origin = (ray.origin - space.centre()) * space.scale() + shift * direction;
    const double slack = 0x1p-40 + 0x1p-48 * max_abs(space.centre()) * space.scale() +
                         0x1p-46 * spread * std::abs(shift);
    return {Vec3f(origin - Vec3(local.origin)), static_cast<float>(slack)};
}

/// Returns whether the ray's line misses the box of all that is bounded, or the ray starts behind
/// it, beyond all roundings and from any distance. Tests the separating axes that are perpendicular
/// to the line and to the box's sides (Gottschalk, Lin & Manocha 1996, SIGGRAPH '96). It needs no
/// division, and most rays to instances need no other test. It does not hold for hits on
/// instances if the ray is not resolved.
inline bool misses_bounds(const NormalizedSpace& space, const Ray& ray) {
    const Vec3 o = ray.origin - space.centre(), &d = ray.direction, &reach = space.reach();
    for (int k = 0; k < 3; ++k) {
        if (std::abs(o[k]) > reach[k] * (1 + 0x1p-40) && o[k] * d[k] > 0) return true;
    }
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const double a = o[i] * d[j], b = o[j] * d[i];
        const double within = reach[i] * std::abs(d[j]) + reach[j] * std::abs(d[i]);
        const double roundings = 0x1p-40 * (std::abs(a) + std::abs(b)) + 0x1p-1000;
        if (std::abs(a - b) > within + roundings) return true;
    }
    return false;
}

}  // namespace etalon
