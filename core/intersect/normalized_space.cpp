#include "core/intersect/normalized_space.h"

#include "core/intersect/normalized_ray.h"

namespace etalon {
namespace {

constexpr double furthest_origin = 0x1p1000;

}  // namespace

NormalizedSpace::NormalizedSpace(const Box3& world, double drift) {
    if (world.isEmpty()) return;
    centre_ = world.center();
    // Far from the origin the centre is rounded, so the two faces differ in distance from it.
    const Vec3 above = world.max - centre_, below = centre_ - world.min;
    const Vec3 half(std::max(above.x, below.x), std::max(above.y, below.y),
                    std::max(above.z, below.z));
    scale_ = power_of_two_reciprocal(max_abs(half)) / 2;
    reach_ = half + Vec3(margin / scale_ + drift * max_abs(half));
}

Box3f NormalizedSpace::box(const Box3& world, double pad) const {
    const Box3 local((world.min - centre_) * scale_ - Vec3(pad),
                     (world.max - centre_) * scale_ + Vec3(pad));
    return round_outward(local);
}

std::optional<NormalizedRay> NormalizedSpace::ray(const Ray& ray) const {
    return normalized_ray(*this, ray);
}

bool NormalizedSpace::resolves(const Ray& ray) const {
    return is_resolved(*this, ray);
}

/// The point of the line nearest to the origin is off by at most 2^-49 of the distance, and an
/// instance's ray by 2^-29 of it: see instance_bounds().
bool NormalizedSpace::surely_misses(const Ray& ray) const {
    const Vec3 direction = ray.direction * power_of_two_reciprocal(max_abs(ray.direction));
    const Vec3 origin = (ray.origin - centre_) * scale_;
    if (!(max_abs(origin) < furthest_origin)) return false;  // products may overflow
    const Vec3 nearest = origin - origin.dot(direction) / direction.dot(direction) * direction;
    return max_abs(nearest) > 2 + 0x1p-20 * max_abs(origin);
}

}  // namespace etalon
