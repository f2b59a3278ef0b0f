#include "core/intersect/normalized_space.h"

namespace etalon {

NormalizedSpace::NormalizedSpace(const Box3& world) {
    if (world.isEmpty()) return;
    centre_ = world.center();
    const double half = std::max(max_abs(world.max - centre_), max_abs(world.min - centre_));
    scale_ = power_of_two_reciprocal(half) / 2;
    reach_ = (world.max - centre_) * scale_ + Vec3(margin);
}

Box3f NormalizedSpace::box(const Box3& world) const {
    const Box3 local((world.min - centre_) * scale_ - Vec3(padding),
                     (world.max - centre_) * scale_ + Vec3(padding));
    return round_outward(local);
}

std::optional<NormalizedRay> NormalizedSpace::ray(const Ray& ray) const {
    const double shrink = power_of_two_reciprocal(max_abs(ray.direction));
    const Vec3 direction = ray.direction * shrink;
    Vec3 origin = (ray.origin - centre_) * scale_;
    double shift = 0;
    if (max_abs(origin) > largest_origin) {
        // The scene lies within sqrt(3) of normalized space's origin: start 2 before the closest
        // approach.
        const double length2 = direction.dot(direction);
        shift = -origin.dot(direction) / length2 - 2 / std::sqrt(length2);
        origin += shift * direction;
        if (max_abs(origin) > largest_origin) return std::nullopt;
    }
    const double scale = scale_ / shrink;
    return NormalizedRay{Vec3f(origin), Vec3f(direction), shift / scale, scale};
}

bool NormalizedSpace::resolves(const Ray& ray) const {
    const double distance = max_abs(ray.origin - centre_) * scale_;
    const double speed = max_abs(ray.direction) * scale_;
    return distance < largest_distance && speed > 1 / largest_speed && speed < largest_speed;
}

/// The point of the line next to the origin is good to 2^-49 of the distance, and an instance's ray
/// to 2^-29 of it: see instance_bounds().
bool NormalizedSpace::surely_misses(const Ray& ray) const {
    const Vec3 direction = ray.direction * power_of_two_reciprocal(max_abs(ray.direction));
    const Vec3 origin = (ray.origin - centre_) * scale_;
    const Vec3 nearest = origin - origin.dot(direction) / direction.dot(direction) * direction;
    return max_abs(nearest) > 2 + 0x1p-20 * max_abs(origin);
}

}  // namespace etalon
