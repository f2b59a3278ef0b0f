// Rays for which the kernels of flat shapes need the whole of their error bounds.
#include "core/intersect/kernels.h"
#include "core/numerics/random.h"
#include "core/oracle/definitions.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

/// The same triangle twice, the second time as a polygon, and its plane.
struct TriangleCase {
    Geometry geometry;
    Vec3 inside, normal;
};

TriangleCase any_triangle(Random& random) {
    TriangleCase c;
    const Vec3 a = random.in_cube(), b = random.in_cube(), d = random.in_cube();
    for (const Vec3& corner : {a, b, d}) c.geometry.add_vertex(corner);
    c.geometry.add(Triangle{{0, 1, 2}}, 0);
    c.geometry.add(Polygon{std::array{a, b, d}}, 0);
    const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
    c.inside = (1 - u - v) * a + u * b + v * d;
    c.normal = unit_vector((b - a).cross(d - a));
    c.geometry.add(Plane{a, c.normal}, 0);
    return c;
}

/// Checks a ray at a primitive against the oracle, if that is certain. Returns whether it hits.
bool check(const Geometry& geometry, std::uint32_t primitive, const Ray& ray) {
    const double t = primitive_first_hit(geometry, primitive, RayQuery(ray));
    CAPTURE(primitive, ray.origin, ray.direction, t);
    for (const Crossing& c : crossings(geometry, primitive, ray)) {
        const auto exact = static_cast<double>(c.t.value);
        const bool has_sign = std::abs(exact) > static_cast<double>(c.t.error);
        if (c.exists == Certainty::unknown || !has_sign) return false;
        const bool is_hit = c.exists == Certainty::yes && exact > 0;
        REQUIRE(is_hit == (t > 0));
        if (is_hit) REQUIRE(std::abs(t - exact) <= t_tolerance * exact);
    }
    return t > 0;
}

}  // namespace

TEST_CASE("Flat shapes: given one seen at any angle, then t is good") {
    Random random(51);
    int hits = 0;
    for (int i = 0; i < 40000; ++i) {
        const TriangleCase c = any_triangle(random);
        const double slope = std::ldexp(random.uniform(1, 2), -(i % 50));
        const Vec3 along = unit_vector(c.normal.cross(random.direction()));
        const Vec3 direction = along - slope * c.normal;
        CAPTURE(i, slope);
        const Ray ray{c.inside - random.uniform(0.5, 3) * direction, direction};
        for (const std::uint32_t primitive : {0U, 1U, 2U})
            hits += check(c.geometry, primitive, ray);
    }
    REQUIRE(hits > 20000);
}

TEST_CASE(
    "Triangles, polygons: given a start at any height above or below, then its side is exact") {
    Random random(52);
    int hits = 0;
    for (int i = 0; i < 40000; ++i) {
        const TriangleCase c = any_triangle(random);
        const double height = random.sign() * std::ldexp(random.uniform(1, 2), -(i % 60));
        const Ray ray{c.inside + height * c.normal, random.direction()};
        CAPTURE(i, height);
        for (const std::uint32_t primitive : {0U, 1U, 2U})
            hits += check(c.geometry, primitive, ray);
    }
    REQUIRE(hits > 10000);
}
