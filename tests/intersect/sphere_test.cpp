// Rays for which a sphere's kernel needs the whole of its error bounds.
#include "core/intersect/shapes/sphere.h"

#include "core/numerics/random.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

Sphere any_sphere(Random& random) {
    return {random.in_cube(), std::exp2(random.uniform(-6, 6))};
}

double exact_hit(const Sphere& s, const Ray& ray) {
    return exact_first_hit(s, Sides::both, RayQuery(ray));
}

double hit(const Sphere& s, const Ray& ray) {
    return first_hit(Geometry{}, s, Sides::both, RayQuery(ray));
}

}  // namespace

TEST_CASE("Sphere: given rays within a few roundings of a tangent, then hit and miss are exact") {
    Random random(41);
    int hits = 0, misses = 0;
    for (int i = 0; i < 40000; ++i) {
        const Sphere s = any_sphere(random);
        const Vec3 direction = random.in_cube();
        const Vec3 across = unit_vector(direction.cross(random.direction()));
        const double beside = 1 + random.uniform(-4, 4) * unit_roundoff;
        const Ray ray{s.centre + s.radius * beside * across - random.uniform(0, 3) * direction,
                      direction};
        const double t = hit(s, ray), exact = exact_hit(s, ray);
        CAPTURE(i, s.centre, s.radius, ray.origin, ray.direction, t, exact);
        REQUIRE(std::isnan(t) == std::isnan(exact));
        (std::isnan(t) ? misses : hits) += 1;
    }
    REQUIRE(std::min(hits, misses) > 10000);
}

TEST_CASE("Sphere: given a ray from any height above or below its surface, then t is good") {
    Random random(42);
    int short_ways = 0;
    for (int i = 0; i < 100000; ++i) {
        const Sphere s = any_sphere(random);
        const Vec3 normal = random.direction();
        // Below 2^-16 plain doubles no longer give the gap to the surface.
        const int binade = i % 2 == 0 ? 15 + i / 2 % 3 : i / 2 % 64;
        const double height = random.sign() * std::ldexp(random.uniform(1, 2), -binade);
        const Vec3 towards = (height > 0 ? -1.0 : 1.0) * normal + 0.9 * random.in_cube();
        const Ray ray{s.centre + s.radius * (1 + height) * normal, towards};
        const double t = hit(s, ray), exact = exact_hit(s, ray);
        CAPTURE(i, height, s.centre, s.radius, ray.origin, ray.direction, t, exact);
        REQUIRE(std::isnan(t) == std::isnan(exact));
        if (std::isnan(t)) continue;
        REQUIRE(std::abs(t - exact) <= t_tolerance * exact);
        short_ways += t < 1e-6;
    }
    REQUIRE(short_ways > 10000);
}

TEST_CASE("Sphere: given a start nearer to its surface than any rounding, then t is good") {
    Random random(43);
    for (int i = 0; i < 20000; ++i) {
        const Sphere s{Vec3(0), std::exp2(random.uniform(-6, 6))};
        // Two coordinates put it near the surface; the third takes most of what is left.
        const double turn = random.uniform(0.1, 1.4);
        const double x = s.radius * std::cos(turn), y = s.radius * std::sin(turn) * (1 - 0x1p-50);
        const double left = std::sqrt(-fine_gap(s, {x, y, 0}));
        const double z = left * (1 + random.sign() * std::ldexp(random.uniform(1, 2), -(i % 60)));
        const Ray ray{{x, y, z}, random.direction()};
        const double t = hit(s, ray), exact = exact_hit(s, ray);
        CAPTURE(i, s.radius, ray.origin, ray.direction, t, exact);
        REQUIRE(std::isnan(t) == std::isnan(exact));
        if (t > 0) REQUIRE(std::abs(t - exact) <= t_tolerance * exact);
    }
}
