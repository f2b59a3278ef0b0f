#include "tests/intersect/rays_at_shapes.h"

namespace etalon {
namespace {

using RayTarget = std::function<Vec3(const Vec3& from)>;

Ray towards(const Vec3& origin, const Vec3& target) {
    return {origin, target - origin};
}

Ray from_afar(const ShapeCase& shape, const RayTarget& ray_target, Random& random) {
    const double distance = std::pow(10.0, random.uniform(0, 7)) * shape.size;
    const Vec3 origin = shape.centre + distance * random.direction();
    Ray ray = towards(origin, ray_target(origin));
    if (random.index(2) == 0) ray.direction /= ray.direction.length();
    return ray;
}

Ray from_close_by(const ShapeCase& shape, const RayTarget& ray_target, Random& random) {
    const Vec3 target = ray_target(shape.centre + 10 * shape.size * random.direction());
    const double distance = std::pow(10.0, random.uniform(-7, 0)) * shape.size;
    return towards(target + distance * random.direction(), target);
}

Ray from_within(const ShapeCase& shape, const RayTarget& ray_target, Random& random) {
    const Vec3 origin = shape.centre + 0.3 * shape.size * random.in_cube();
    return towards(origin, ray_target(origin));
}

/// Returns a ray that starts at the target, on or next to the surface.
Ray from_the_target(const ShapeCase& shape, const RayTarget& ray_target, Random& random) {
    return {ray_target(shape.centre + 10 * shape.size * random.direction()), random.direction()};
}

/// Returns a ray along an axis, with zeros of both signs.
Ray along_an_axis(const ShapeCase& shape, const RayTarget& ray_target, Random& random) {
    const int k = random.axis();
    Vec3 direction(random.sign() * 0.0, random.sign() * 0.0, random.sign() * 0.0);
    direction[k] = random.sign();
    const Vec3 target = ray_target(shape.centre + 10 * shape.size * random.direction());
    Vec3 origin = target;
    origin[k] = shape.centre[k] - 3 * shape.size * direction[k];
    return {origin, direction};
}

Ray along_a_plane(const ShapeCase& shape, const RayTarget& ray_target, Random& random) {
    const Vec3 target = ray_target(shape.centre + 10 * shape.size * random.direction());
    Vec3 direction = random.direction();
    direction[random.axis()] = random.sign() * 0.0;
    return {target - 4 * shape.size * direction, direction};
}

Ray with_a_denormal(const ShapeCase& shape, const RayTarget& ray_target, Random& random) {
    Ray ray = along_an_axis(shape, ray_target, random);
    const int k = random.axis();
    if (ray.direction[k] == 0) ray.direction[k] = random.sign() * 1e-310 * random.uniform();
    return ray;
}

/// Returns a ray through two targets: along an edge, a generator or a face.
Ray through_two(const ShapeCase& shape, const RayTarget& ray_target, Random& random) {
    const Vec3 a = ray_target(shape.centre + 10 * shape.size * random.direction());
    const Vec3 b = ray_target(shape.centre + 10 * shape.size * random.direction());
    const Vec3 direction = a == b ? random.direction() : b - a;
    return {a - random.uniform(0, 4) * direction, direction};
}

struct RayGenerator {
    const char* name;
    Ray (*make)(const ShapeCase&, const RayTarget&, Random&);
};

constexpr RayGenerator ray_generators[] = {
    {"from afar", from_afar},
    {"from close by", from_close_by},
    {"from within", from_within},
    {"from the target", from_the_target},
    {"along an axis", along_an_axis},
    {"along a plane", along_a_plane},
    {"with a denormal", with_a_denormal},
    {"through two", through_two},
};

}  // namespace

AimedRay aimed_ray(const ShapeCase& shape, int index, Random& random) {
    const auto number = static_cast<std::size_t>(index);
    const Target& target = shape.targets[number % shape.targets.size()];
    const RayGenerator& ray_generator =
        ray_generators[number / shape.targets.size() % std::size(ray_generators)];
    const RayTarget ray_target = [&](const Vec3& from) { return target.point(random, from); };
    return {ray_generator.make(shape, ray_target, random), ray_generator.name, &target.name};
}

}  // namespace etalon
