#include "bench/hard_cases/ray_generators.h"

#include "bench/hard_cases/ray_targets.h"

namespace etalon::hard {
namespace {

/// Returns a point of the target, as chosen for a ray from a random point at a distance of ten
/// sizes.
Vec3 seen_from_around(const Extent& extent, const Target& target, Random& random) {
    const Vec3 from = extent.centre + 10 * extent.size * random.direction();
    return target(from, random);
}

/// Returns a ray from 1 to 1e7 sizes away, half of the time with a normalised direction.
Ray from_afar(const Extent& extent, const Target& target, Random& random) {
    const double distance = extent.size * random.magnitude(0, 7);
    const Vec3 origin = extent.centre + distance * random.direction();
    Ray ray = towards(origin, target(origin, random));
    if (random.index(2) == 0) ray.direction.normalize();
    return ray;
}

/// Returns a ray from 1e-7 to 1 sizes away.
Ray from_close_by(const Extent& extent, const Target& target, Random& random) {
    const Vec3 point = seen_from_around(extent, target, random);
    const double distance = extent.size * random.magnitude(-7, 0);
    return towards(point + distance * random.direction(), point);
}

Ray from_within(const Extent& extent, const Target& target, Random& random) {
    const Vec3 origin = extent.centre + 0.3 * extent.size * random.in_cube();
    return towards(origin, target(origin, random));
}

Ray along_an_axis(const Extent& extent, const Target& target, Random& random) {
    const Vec3 direction = axis_direction(random);
    const int k = dominant_axis(direction);
    Vec3 origin = seen_from_around(extent, target, random);
    origin[k] = extent.centre[k] - 3 * extent.size * direction[k];
    return {origin, direction};
}

/// Returns a direction perpendicular to an axis, with a zero of either sign.
Ray across_an_axis(const Extent& extent, const Target& target, Random& random) {
    const Vec3 point = seen_from_around(extent, target, random);
    Vec3 direction = random.direction();
    const int axis = random.axis();
    direction[axis] = random.sign() * 0.0;
    return {point - 4 * extent.size * direction, direction};
}

Ray with_a_denormal(const Extent& extent, const Target& target, Random& random) {
    Ray ray = along_an_axis(extent, target, random);
    const int k = random.axis();
    if (ray.direction[k] == 0) ray.direction[k] = 1e-310 * random.uniform(-1, 1);
    return ray;
}

using RayGenerator = Ray (*)(const Extent&, const Target&, Random&);

constexpr RayGenerator ray_generators[] = {from_afar,     from_close_by,  from_within,
                                           along_an_axis, across_an_axis, with_a_denormal};

}  // namespace

Ray ray_generator(const Extent& extent, const Target& target, Random& random) {
    const RayGenerator chosen = ray_generators[random.index(std::size(ray_generators))];
    Ray ray = chosen(extent, target, random);
    // A target may be at the origin of the ray.
    if (max_abs(ray.direction) == 0) ray.direction = random.direction();
    return ray;
}

Ray leave(const Extent& extent, const Target& target, Random& random) {
    const Vec3 origin = seen_from_around(extent, target, random);
    return {origin, random.direction()};
}

Ray through_two(const Extent& extent, const Target& target, Random& random) {
    const Vec3 a = seen_from_around(extent, target, random);
    const Vec3 b = seen_from_around(extent, target, random);
    const Vec3 direction = a == b ? random.direction() : b - a;
    return {a - random.uniform(0, 4) * direction, direction};
}

}  // namespace etalon::hard
