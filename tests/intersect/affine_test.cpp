// Images of unit shapes: tests beyond the table of shapes.
#include "core/intersect/kernels.h"
#include "core/intersect/shapes/all_shapes.h"
#include "tests/catch.h"
#include "tests/intersect/rays_at_shapes.h"

using namespace etalon;

namespace {

template <class Shape>
double hit(const Shape& shape, const Ray& ray, Sides sides = Sides::both) {
    return first_hit(Geometry{}, shape, sides, RayQuery(ray));
}

Affine any_map(Random& random) {
    return {random.in_cube(), random.in_cube(), random.in_cube(), random.in_cube()};
}

/// Returns a ray whose origin and target are a few sizes away from the shape.
Ray any_ray(const Affine& map, Random& random) {
    const double size = map.x.length() + map.y.length() + map.z.length();
    const Vec3 origin = map.origin + random.uniform(0, 10) * size * random.direction();
    return {origin, map.point(1.2 * random.in_cube()) - origin};
}

double fast_path(const Revolved& s, Sides sides, const RayQuery& q) {
    return RevolvedFastPath(s, q).first_hit(sides);
}

template <class Image>
double exact_hit(const Image& image, Sides sides, const RayQuery& q) {
    const Passage x = exact_passage(image, q.ray);
    return first_visible(x.entry, x.exit, sides, q.ray.tmin);
}

double exact_hit(const Revolved& s, Sides sides, const RayQuery& q) {
    return exact_first_hit(s, sides, q.ray);
}

const ClosedCylinder can{Affine{}};
const Ellipsoid ball{Affine{}};

}  // namespace

TEST_CASE("Ellipsoid: given the unit sphere, then t is that of the sphere") {
    Random random(30);
    const Sphere sphere{{0, 0, 0}, 1};
    for (int i = 0; i < 1000; ++i) {
        const Ray ray = any_ray({}, random);
        const auto sides = static_cast<Sides>(random.index(3));
        const double t = hit(ball, ray, sides), same = hit(sphere, ray, sides);
        CAPTURE(i, t, same);
        REQUIRE(std::isnan(t) == std::isnan(same));
        if (t > 0) REQUIRE(std::abs(t - same) <= t_tolerance * t);
    }
}

TEST_CASE("Ellipsoid: given a tangent and adjacent lines, then only those outside miss") {
    const Ellipsoid wide{Affine{{4, 0, 0}, {0, 0.5, 0}, {0, 0, -2}, {0, 0, 0}}};
    REQUIRE(hit(wide, {{4, 0, -8}, {0, 0, 1}}) == 8);
    REQUIRE(hit(wide, {{-8, 0.5, 0}, {1, 0, 0}}) == 8);
    REQUIRE(hit(wide, {{-8, 0.5 - 0x1p-54, 0}, {1, 0, 0}}) < 8);
    REQUIRE(std::isnan(hit(wide, {{-8, 0.5 + 0x1p-53, 0}, {1, 0, 0}})));
    REQUIRE(std::isnan(hit(wide, {{4 + 0x1p-50, 0, -8}, {0, 0, 1}})));
}

TEST_CASE("Closed cylinder: given rays at its faces, then the solid's ends are hit") {
    REQUIRE(hit(can, {{0.5, 0, 4}, {0, 0, -1}}) == 3);
    REQUIRE(hit(can, {{0.5, 0, 4}, {0, 0, -1}}, Sides::back) == 4);
    REQUIRE(hit(can, {{-3, 0, 0.5}, {1, 0, 0}}) == 2);
    REQUIRE(hit(can, {{-3, 0, 0.5}, {1, 0, 0}}, Sides::back) == 4);
    REQUIRE(hit(can, {{0, 0, 0.5}, {0, 0, -2}}) == 0.25);
    REQUIRE(hit(can, {{-2, 0, -1}, {1, 0, 1}}) == 1);        // through the base's rim
    REQUIRE(hit(can, {{-1.5, 0, -1}, {1, 0, 1}}) == 1);      // the base
    REQUIRE(hit(can, {{-1.5, 0, 0.25}, {1, 0, 1}}) == 0.5);  // the side, and out by the top
}

TEST_CASE("Closed cylinder: given a line in a face, then it hits the solid") {
    REQUIRE(hit(can, {{-3, 0, 0}, {1, 0, 0}}) == 2);
    REQUIRE(hit(can, {{-3, 0, 1}, {1, 0, 0}}) == 2);
    REQUIRE(hit(can, {{1, 0, -3}, {0, 0, 1}}) == 3);
    REQUIRE(hit(can, {{0, -1, 5}, {0, 0, -1}}) == 4);
    REQUIRE(std::isnan(hit(can, {{-3, 0, -0x1p-1074}, {1, 0, 0}})));
    REQUIRE(std::isnan(hit(can, {{-3, 0, 1 + 0x1p-52}, {1, 0, 0}})));
    REQUIRE(std::isnan(hit(can, {{1 + 0x1p-52, 0, -3}, {0, 0, 1}})));
}

TEST_CASE("Closed cylinder: given a line past a rim, then one that touches it hits") {
    const Vec3 up(1, 0, 1);  // across the base's rim at (1, 0, 0), and down outside
    REQUIRE(hit(can, {Vec3(1, 0, 0) - 2.0 * up, up}) == 2);
    REQUIRE(std::isnan(hit(can, {Vec3(1 + 0x1p-52, 0, 0) - 2.0 * up, up})));
    REQUIRE(hit(can, {Vec3(1 - 0x1p-53, 0, 0) - 2.0 * up, up}) == 2);
}

TEMPLATE_TEST_CASE("Images: given a mirrored unit shape, then it is the same shape", "", Ellipsoid,
                   ClosedCylinder) {
    Random random(31);
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        const Affine map = any_map(random);
        const TestType shape(map), mirrored(Affine{map.x, -map.y, map.z, map.origin});
        const RayQuery query(any_ray(map, random));
        const double t = first_hit(Geometry{}, shape, Sides::front, query);
        const double same = first_hit(Geometry{}, mirrored, Sides::front, query);
        CAPTURE(i, t, same);
        REQUIRE(std::isnan(t) == std::isnan(same));
        if (std::isnan(t)) continue;
        ++hits;
        REQUIRE(std::abs(t - same) <= t_tolerance * t);
        const Vec3 normal = surface(Geometry{}, shape, query, t).normal;
        const Vec3 same_normal = surface(Geometry{}, mirrored, query, t).normal;
        REQUIRE(normal.dot(query.ray.direction) < 0);
        REQUIRE((normal - same_normal).length() < 1e-6);
    }
    REQUIRE(hits > 300);
}

TEMPLATE_TEST_CASE(
    "Images: given any ray, then exact arithmetic says what the fast path is certain of", "",
    Ellipsoid, ClosedCylinder, Revolved) {
    int uncertain_answers = 0, hits = 0, rays = 0;
    for (const ShapeCase& shape : shape_cases()) {
        if (shape.scene.geometry.primitives[0].kind != kind_of<TestType>()) continue;
        const TestType& image = shape.scene.geometry.all<TestType>()[0];
        Random random(32);
        for (int i = 0; i < 10000; ++i) {
            const RayQuery query(aimed_ray(shape, i, random).ray);
            const auto sides = static_cast<Sides>(random.index(3));
            const double t = fast_path(image, sides, query);
            ++rays;
            uncertain_answers += t == uncertain;
            if (t == uncertain) continue;
            const double exact = exact_hit(image, sides, query);
            CAPTURE(shape.name, i, t, exact);
            REQUIRE(std::isnan(t) == std::isnan(exact));
            hits += t > 0;
            if (t > 0) REQUIRE(std::abs(t - exact) <= t_tolerance * exact);
        }
    }
    CAPTURE(uncertain_answers, hits, rays);
    REQUIRE(hits > rays / 5);
    REQUIRE(uncertain_answers > rays / 100);  // otherwise these rays are too easy
}

TEMPLATE_TEST_CASE(
    "Images: given rays from a few sizes off, then the fast path is uncertain of hardly any", "",
    Ellipsoid, ClosedCylinder) {
    Random random(33);
    int uncertain_answers = 0;
    for (int i = 0; i < 50000; ++i) {
        const Affine map = any_map(random);
        const TestType shape(map);
        uncertain_answers +=
            fast_path(shape, Sides::both, RayQuery(any_ray(map, random))) == uncertain;
    }
    REQUIRE(uncertain_answers <= 250);
}

TEMPLATE_TEST_CASE("Images: given a map and a ray of any size, then t is the same times that size",
                   "", Ellipsoid, ClosedCylinder) {
    const int k = GENERATE(-950, -500, 500, 950), speed = GENERATE(-40, 0, 40);
    const auto scaled = [k](const Vec3& v) {
        return Vec3(std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k));
    };
    Random random(34);
    for (int i = 0; i < 200; ++i) {
        const Affine map = any_map(random);
        const Affine moved{scaled(map.x), scaled(map.y), scaled(map.z), scaled(map.origin)};
        const Ray ray = any_ray(map, random);
        const double t = hit(TestType(map), ray);
        const double other_t = hit(TestType(moved), {scaled(ray.origin),  //
                                                     std::ldexp(1.0, speed) * ray.direction});
        CAPTURE(i, k, speed, t, other_t);
        REQUIRE(std::isnan(t) == std::isnan(other_t));
        const double same = std::ldexp(t, k - speed);
        if (t > 0 && same < infinity) REQUIRE(std::abs(other_t - same) <= 2 * t_tolerance * same);
    }
}
