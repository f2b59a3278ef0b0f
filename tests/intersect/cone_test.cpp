#include "core/intersect/shapes/cone.h"
#include "core/scene/scene.h"

#include "core/intersect/kernels.h"
#include "core/numerics/random.h"
#include "core/oracle/oracle.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

double hit(const Cone& cone, const Ray& ray, Sides sides = Sides::both) {
    return first_hit(Geometry{}, cone, sides, RayQuery(ray));
}

const Cone cylinder{{0, 0, 0}, {0, 0, 4}, 1, 1};
const Cone pointed{{0, 0, 0}, {0, 0, 2}, 1, 0};

/// Permutes the coordinates, so that the cone's axis is another one.
Vec3 turned(const Vec3& v, int k) {
    return {v[k % 3], v[(k + 1) % 3], v[(k + 2) % 3]};
}

Cone turned(const Cone& c, int k) {
    return {turned(c.base, k), turned(c.top, k), c.base_radius, c.top_radius};
}

/// Returns the ray with one coordinate of its origin moved to the next double in the direction of
/// `towards`.
Ray moved(Ray ray, int k, double towards) {
    ray.origin[k] = std::nextafter(ray.origin[k], towards);
    return ray;
}

/// Returns a cone of any proportions: flat, needle-like, pointed, and all but cylindrical.
Cone random_cone(Random& random) {
    const double length = std::pow(10.0, random.uniform(-4, 3)), radius = random.uniform(0.5, 2);
    const double other[] = {radius, 0,
                            radius * (1 + std::ldexp(1.0, -static_cast<int>(random.index(53)))),
                            random.uniform()};
    Cone c{random.in_cube(), {}, radius, other[random.index(4)]};
    c.top = c.base + length * random.direction();
    if (random.index(2) == 0) std::swap(c.base_radius, c.top_radius);
    return c;
}

/// Returns a ray through the surface, a rim, the axis or its ends, from that point or 1 to 1e7
/// radii away.
Ray random_ray(const Cone& c, Random& random) {
    const Vec3 h = c.top - c.base;
    Vec3 u, v;
    orthonormal_basis(normalized(h), u, v);
    const double s = random.index(2) == 0 ? std::round(random.uniform()) : random.uniform();
    const double angle = random.uniform(0, 6.3), out = random.index(4) == 0 ? 0 : 1;
    const double r = out * (c.base_radius + s * (c.top_radius - c.base_radius));
    const Vec3 target = c.base + s * h + r * (std::cos(angle) * u + std::sin(angle) * v);
    Vec3 direction = random.direction();
    if (random.index(3) == 0) direction -= direction.dot(u) * u;  // some of these are tangents
    const double distance = random.index(4) == 0 ? 0 : std::pow(10.0, random.uniform(0, 7));
    return {target - distance * direction, direction};
}

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

TEST_CASE("Cone: given a line that crosses the mirror nappe first, then it hits the cone only") {
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
                std::abs(surface(Geometry{}, cone, RayQuery(ray), t).normal.dot(direction));
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
    const SurfacePoint p = surface(Geometry{}, pointed, RayQuery(ray), hit(pointed, ray));
    REQUIRE((p.position - Vec3(-0.5, 0, 1)).length() < 1e-15);
    REQUIRE((p.normal - Vec3(-2, 0, 1) / std::sqrt(5.0)).length() < 1e-15);
}

TEST_CASE("Cone: given a tangent to the last bit, then it is hit, and the next line is not") {
    const Cone upright{{0, 0, 0}, {0, 0, 8}, 5, 5};
    for (int i = 0; i < 3 * 12; ++i) {
        const int k = i % 3, slope = i / 3 % 4 - 1;
        const double n = std::pow(10.0, i / 12 * 3 + 1);
        const Vec3 d(-4, 3, slope), at(3, 4, 3);
        const Ray ray{turned(at - n * d, k), turned(d, k)};
        const Cone cone = turned(upright, k);
        const int x = (3 - k) % 3;  // the x axis after turned()
        CAPTURE(k, slope, n);
        REQUIRE(hit(cone, ray) == n);
        REQUIRE(std::isnan(hit(cone, moved(ray, x, infinity))));
        REQUIRE(hit(cone, moved(ray, x, -infinity)) == Approx(n).epsilon(1e-3));
    }
}

TEST_CASE("Cone: given a tangent that touches a rim, then either side is hit") {
    const Cone upright{{0, 0, 0}, {0, 0, 8}, 5, 5};
    for (const double z : {0.0, 8.0}) {
        for (const Vec3& d : {Vec3(-4, 3, 1), Vec3(-4, 3, -1), Vec3(-4, 3, 0)}) {
            const Ray ray{Vec3(3, 4, z) - 10.0 * d, d};
            REQUIRE(hit(upright, ray, Sides::front) == 10);
            REQUIRE(hit(upright, ray, Sides::back) == 10);
        }
    }
}

TEST_CASE("Cone: given a ray through a rim to the last bit, then it is hit, and none beyond") {
    const Cone upright{{0, 0, 0}, {0, 0, 8}, 5, 5}, narrowing{{0, 0, 0}, {0, 0, 8}, 5, 1};
    for (int i = 0; i < 3 * 12; ++i) {
        const int k = i % 3, z = (5 - k) % 3;
        const double n = std::pow(10.0, i / 12 * 3 + 1);
        const Vec3 d(-1, -2, i / 3 % 4 - 1);
        for (const Cone& shape : {upright, narrowing}) {
            const bool top = i % 2 == 0 && shape.top_radius == 5;
            const Ray ray{turned(Vec3(3, 4, top ? 8 : 0) - n * d, k), turned(d, k)};
            const Ray fast{ray.origin, 3.0 * ray.direction};  // whose t is rounded
            const Cone cone = turned(shape, k);
            CAPTURE(k, n, d, top);
            REQUIRE(hit(cone, ray, Sides::front) == n);
            REQUIRE(std::isnan(hit(cone, moved(ray, z, top ? infinity : -infinity), Sides::front)));
            REQUIRE(hit(cone, fast, Sides::front) == n / 3);
            REQUIRE(
                std::isnan(hit(cone, moved(fast, z, top ? infinity : -infinity), Sides::front)));
            if (d.z != 0) continue;
            REQUIRE(hit(cone, moved(ray, z, 4), Sides::front) == Approx(n));
        }
    }
}

TEST_CASE("Cone: given lines through the apex to the last bit, then they hit it") {
    const Cone cone{{0, 0, 0}, {0, 0, 8}, 5, 0};
    for (const double n : {1.0, 3.0, 1e4, 1e7}) {
        for (const Vec3& steep : {Vec3(1, 2, -7), Vec3(-1, 3, -9), Vec3(0, 0, -1)}) {
            const Ray down{cone.top - n * steep, steep}, up{cone.top + n * steep, -steep};
            REQUIRE(hit(cone, down, Sides::front) == n);
            REQUIRE(std::isnan(hit(cone, down, Sides::back)));
            REQUIRE(hit(cone, up, Sides::back) == n);
            REQUIRE(std::isnan(hit(cone, up, Sides::front)));
        }
        for (const Vec3& shallow : {Vec3(1, 2, -3), Vec3(-2, 3, 1), Vec3(1, 1, 0)}) {
            const Ray ray{cone.top - n * shallow, shallow};
            REQUIRE(hit(cone, ray) == n);
            REQUIRE(std::isnan(hit(cone, moved(ray, 2, infinity))));
            REQUIRE(hit(cone, moved(ray, 2, -infinity)) == Approx(n));
        }
    }
}

TEST_CASE("Cone: given lines along a generator, then only those beside it hit, and once") {
    const Cone cone{{0, 0, 0}, {0, 0, 8}, 5, 0};
    const Vec3 generator(-3, -4, 8);
    for (const double n : {0.0, 1.0, 1000.0, 1e7}) {
        REQUIRE(std::isnan(hit(cone, {Vec3(3, 4, 0) - n * generator, generator})));
        REQUIRE(hit(cone, {-n * generator, generator}) == n + 0.5);
        REQUIRE(hit(cone, {(n + 1) * generator, -generator}, Sides::front) == n + 0.5);
    }
}

TEST_CASE("Cone: given a cone as flat as can be, then it is hit where a ring would be") {
    for (int k = 0; k <= 1000; k += 20) {
        const double height = std::ldexp(1.0, -k);
        const Cone flat{{0, 0, 0}, {0, 0, height}, 1, 0.25};
        CAPTURE(k);
        REQUIRE(hit(flat, {{0.625, 0, 4}, {0, 0, -1}}) == 4 - height / 2);
        REQUIRE(hit(flat, {{1, 0, 4}, {0, 0, -1}}) == 4);
        REQUIRE(hit(flat, {{0.25, 0, 4}, {0, 0, -1}}) == 4 - height);
        REQUIRE(std::isnan(hit(flat, {{1 + 0x1p-52, 0, 4}, {0, 0, -1}})));
        REQUIRE(std::isnan(hit(flat, {{0.25 - 0x1p-54, 0, 4}, {0, 0, -1}})));
    }
}

TEST_CASE("Cone: given a ray from the surface itself, then t is not zero but the distance across") {
    for (const double reach : {0x1p-40, 1.0, 0x1p40}) {
        REQUIRE(hit(cylinder, {{1, 0, 2}, {-reach, 0, 0}}) == 2 / reach);
        REQUIRE(std::isnan(hit(cylinder, {{1, 0, 2}, {reach, 0, 0}})));
        REQUIRE(std::isnan(hit(cylinder, {{1, 0, 2}, {0, reach, 0}})));
    }
}

TEMPLATE_TEST_CASE(
    "Cone: given any ray, then exact arithmetic agrees with each certain decision of the fast path",
    "", ConeFastPath, ConeBoundsCheck) {
    Random random(20);
    int uncertain_answers = 0, hits = 0;
    const int count = 200000;
    for (int i = 0; i < count; ++i) {
        const Cone cone = random_cone(random);
        const RayQuery query(random_ray(cone, random));
        const auto sides = static_cast<Sides>(random.index(3));
        const double t = TestType(cone, query).first_hit(sides);
        uncertain_answers += t == uncertain;
        if (t == uncertain) continue;
        const Passage x = exact_passage(cone, query.ray);
        const double exact = first_visible(x.entry, x.exit, sides, query.ray.tmin);
        CAPTURE(i, t, exact);
        REQUIRE(std::isnan(t) == std::isnan(exact));
        if (std::isnan(t)) continue;
        ++hits;
        REQUIRE(std::abs(t - exact) <= t_tolerance * exact);
    }
    CAPTURE(uncertain_answers, hits);
    REQUIRE(hits > count / 5);
    REQUIRE(uncertain_answers > count / 100);  // otherwise these rays are too easy
}

TEST_CASE("Cone: given a cone and a ray of any size, then t is the same times that size") {
    const int k = GENERATE(-700, -500, -300, 300, 500, 700), speed = GENERATE(-200, 0, 200);
    const auto resized = [k](double x) { return std::ldexp(x, k); };
    const auto scaled = [&](const Vec3& v) {
        return Vec3(resized(v.x), resized(v.y), resized(v.z));
    };
    Random random(23);
    for (int i = 0; i < 500; ++i) {
        const Cone cone = random_cone(random);
        const Cone other{scaled(cone.base), scaled(cone.top), resized(cone.base_radius),
                         resized(cone.top_radius)};
        const Ray ray = random_ray(cone, random);
        const double t = hit(cone, ray);
        const Ray moved{scaled(ray.origin), std::ldexp(1.0, speed) * ray.direction};
        const double other_t = hit(other, moved);
        CAPTURE(i, k, speed, t, other_t);
        REQUIRE(std::isnan(t) == std::isnan(other_t));
        if (std::isnan(t)) continue;
        REQUIRE(std::abs(std::ldexp(other_t, speed - k) - t) <= 0x1p-39 * t);
        const Box3 box = bounds(Geometry{}, other);
        const Vec3 p = moved.origin + other_t * moved.direction;
        const double slack = resized(1e-14 * (1e3 + ray.origin.length()));
        for (int axis = 0; axis < 3; ++axis) {
            REQUIRE(p[axis] >= box.min[axis] - slack);
            REQUIRE(p[axis] <= box.max[axis] + slack);
        }
    }
}

TEST_CASE("Cone: given rays from ten radii at its surroundings, then no tier doubts many") {
    Random random(21);
    int fast_path = 0, filter = 0;
    for (int i = 0; i < 50000; ++i) {
        const Cone& cone = i % 2 == 0 ? cylinder : pointed;
        const Vec3 origin = 10.0 * random.direction();
        const RayQuery query(Ray{origin, 2.0 * random.in_cube() - origin});
        fast_path += ConeFastPath(cone, query).first_hit(Sides::both) == uncertain;
        filter += ConeBoundsCheck(cone, query).first_hit(Sides::both) == uncertain;
    }
    REQUIRE(fast_path <= 500);
    REQUIRE(filter <= 5);
}

TEST_CASE("exact_passage: given any ray, then the oracle agrees") {
    Random random(22);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const Cone cone = random_cone(random);
        Scene scene;
        scene.geometry.add(cone, 0);
        const Ray ray = random_ray(cone, random);
        const Passage x = exact_passage(cone, RayQuery(ray).ray);
        const double t = first_visible(x.entry, x.exit, Sides::both, 0);
        const OracleAnswer answer = Oracle(scene.geometry).closest(ray);
        CAPTURE(i, t, answer.t);
        if (answer.kind == OracleAnswer::undecidable) continue;
        REQUIRE((t > 0) == (answer.kind == OracleAnswer::hit));
        if (!(t > 0)) continue;
        ++hits;
        REQUIRE(answer.relative_error(t) <= (t > 1e-3 ? 8 * unit_roundoff : 1e-9));
    }
    REQUIRE(hits > 5000);
}
