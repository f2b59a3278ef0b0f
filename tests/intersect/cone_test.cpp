#include "core/intersect/shapes/cone.h"

#include "core/intersect/kernels.h"
#include "tests/catch.h"
#include "tests/intersect/random.h"

using namespace etalon;

namespace {

double hit(const Cone& cone, const Ray& ray, Sides sides = Sides::both) {
    return first_hit(Scene{}, cone, sides, RayQuery(ray));
}

const Cone cylinder{{0, 0, 0}, {0, 0, 4}, 1, 1};
const Cone pointed{{0, 0, 0}, {0, 0, 2}, 1, 0};

}  // namespace

TEST_CASE("Cone: given rays across a cylinder, then both walls are where they should be") {
    const Ray ray{{-5, 0, 1}, {1, 0, 0}};
    REQUIRE(hit(cylinder, ray) == 4);
    REQUIRE(hit(cylinder, ray, Sides::front) == 4);
    REQUIRE(hit(cylinder, ray, Sides::back) == 6);
    REQUIRE(hit(cylinder, {{-5, 0, 0}, {1, 0, 0}}) == 4);  // the rims belong to it
    REQUIRE(hit(cylinder, {{-5, 0, 4}, {1, 0, 0}}) == 4);
    REQUIRE(std::isnan(hit(cylinder, {{-5, 0, 4.001}, {1, 0, 0}})));
    REQUIRE(hit(cylinder, {{-5, 1, 1}, {1, 0, 0}}) == 5);  // a tangent
}

TEST_CASE("Cone: given rays along a cylinder, then there is nothing to hit: it has no caps") {
    for (const double x : {0.0, 0.5, 1.0, 1.5}) {
        REQUIRE(std::isnan(hit(cylinder, {{x, 0, -3}, {0, 0, 1}})));
        REQUIRE(std::isnan(hit(cylinder, {{x, 0, 2}, {0, 0, -1}})));
    }
}

TEST_CASE("Cone: given a ray through an open end, then the inside is hit") {
    REQUIRE(hit(cylinder, {{0, 0, -1}, {0.5, 0, 1}}) == 2);
    REQUIRE(hit(cylinder, {{0, 0, -1}, {0.5, 0, 1}}, Sides::back) == 2);
    REQUIRE(std::isnan(hit(cylinder, {{0, 0, -1}, {0.5, 0, 1}}, Sides::front)));
    REQUIRE(hit(pointed, {{0.5, 0, -1}, {0, 0, 1}}, Sides::back) == 2);
}

TEST_CASE("Cone: given a line that would meet the mirror nappe first, then it does not") {
    REQUIRE(hit(pointed, {{0.5, 0, 9}, {0, 0, -1}}) == 8);
    REQUIRE(std::isnan(hit(pointed, {{0.5, 0, 9}, {0, 0, -1}}, Sides::back)));
}

TEST_CASE("Cone: given lines steeper than the cone through its apex, then none slips by") {
    Random random(17);
    for (int i = 0; i < 20000; ++i) {
        Cone cone{random.in_cube(), {}, 0.5 + random.uniform(), 0};
        const Vec3 axis = random.direction();
        cone.top = cone.base + 2.0 * axis;
        if (i % 2 == 0)
            std::swap(cone.base, cone.top), std::swap(cone.base_radius, cone.top_radius);
        const Vec3 apex = cone.top_radius == 0 ? cone.top : cone.base;
        const Vec3 tilt = random.direction();
        const Vec3 inward = -axis + 0.2 * (tilt - tilt.dot(axis) * axis);
        const Vec3 origin = apex - random.uniform(0.1, 1e4) * inward;
        const double t = hit(cone, {origin, apex - origin}, Sides::front);
        CAPTURE(i, t);
        REQUIRE(t == Approx(1).epsilon(1e-9));
    }
}

TEST_CASE("Cone: given radii that approach each other, then t approaches the cylinder's") {
    Random random(18);
    for (int i = 0; i < 200; ++i) {
        const Vec3 target(random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9),
                          random.uniform(1, 3));
        const Vec3 direction = random.direction();
        const Ray ray{target - 10.0 * direction, direction};
        const double limit = hit(cylinder, ray, Sides::front);
        if (std::isnan(limit)) continue;
        for (int j = 20; j <= 52; ++j) {
            Cone cone = cylinder;
            cone.top_radius += std::ldexp(1.0, -j);
            const double t = hit(cone, ray, Sides::front);
            if (std::isnan(t)) continue;  // through the rim
            const double cosine =
                std::abs(surface(Scene{}, cone, RayQuery(ray), t).normal.dot(direction));
            CAPTURE(i, j, t, limit);
            REQUIRE(std::abs(t - limit) <= 2 * (std::ldexp(1.0, -j) + 1e-14) / (cosine * cosine));
        }
    }
}

TEST_CASE("Cone: given base and top exchanged, then the same points are hit") {
    Random random(19);
    const Cone cone{{0.1, 0.2, 0.3}, {1, 2, 3}, 1.5, 0.5}, exchanged{cone.top, cone.base, 0.5, 1.5};
    for (int i = 0; i < 2000; ++i) {
        const Vec3 direction = random.direction();
        const Ray ray{random.in_cube() - 5.0 * direction, direction};
        const double t = hit(cone, ray), other = hit(exchanged, ray);
        CAPTURE(i, t, other);
        if (!std::isnan(t) || !std::isnan(other)) REQUIRE(t == Approx(other).epsilon(1e-9));
    }
}

TEST_CASE("Cone: given a hit, then the normal leans as the surface does") {
    const Ray ray{{-5, 0, 1}, {1, 0, 0}};
    const SurfacePoint p = surface(Scene{}, pointed, RayQuery(ray), hit(pointed, ray));
    REQUIRE((p.position - Vec3(-0.5, 0, 1)).length() < 1e-15);
    REQUIRE((p.normal - Vec3(-2, 0, 1) / std::sqrt(5.0)).length() < 1e-15);
}
