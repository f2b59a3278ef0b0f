#include "core/oracle/oracle.h"

#include "core/intersect/kernels.h"
#include "core/intersect/placement.h"
#include "core/oracle/enclosure.h"
#include "core/oracle/tracked.h"
#include "tests/catch.h"
#include "tests/intersect/rays_at_shapes.h"

using namespace etalon;

namespace {

bool is_close(Quad a, Quad b) {
    return magnitude(a - b) <= magnitude(b) * Quad(0x1p-108);
}

/// Returns shapes of every kind at random positions.
Scene mixed_scene(int copies) {
    Scene scene;
    Random random(20);
    for (int i = 0; i < copies; ++i) {
        const Vec3 p = 20.0 * random.in_cube();
        scene.geometry.add(Sphere{p, random.uniform()}, 0);
        scene.geometry.add(Cone{p, p + random.in_cube(), random.uniform(), random.uniform()}, 0,
                           Sides::back);
        scene.geometry.add(Box{p, p + Vec3(0.5, 0.1, 1)}, 0, Sides::front);
        scene.geometry.add(Ring{p, random.in_cube(), 0.25, 0.5}, 0);
        const std::array<double, 10> saddle = {1, 0.5, 0, 0.1, -2, 0, 0, 0, 0.5, 0};
        scene.geometry.add(Quadric{p, saddle, {p - Vec3(0.5), p + Vec3(0.5)}}, 0);
        const std::array square = {p, p + Vec3(1, 0, 0), p + Vec3(1, 1, 0), p + Vec3(0, 1, 0)};
        LargeVector<Vec3>& vertices = scene.geometry.vertices;
        const auto first = static_cast<std::uint32_t>(vertices.size());
        vertices.insert(vertices.end(), square.begin(), square.end());
        scene.geometry.add(Triangle{{first, first + 1, first + 3}}, 0);
        scene.geometry.add(Polygon{square}, 0);
    }
    scene.geometry.add(Plane{{0, 0, -15}, {0, 0.1, 1}}, 0);
    return scene;
}

}  // namespace

TEST_CASE("Tracked: given exact operations, then there is no error") {
    const Tracked a = 0.1, b = 0.7;
    REQUIRE((a * b).error == 0);
    REQUIRE((a - b).error == 0);
    REQUIRE(is_zero(a * b - b * a) == Certainty::yes);
    REQUIRE(is_zero(a * b * a * b - a * a * b * b) != Certainty::no);
    REQUIRE((a / b).error > 0);
    REQUIRE(is_zero(a / b - a / b) == Certainty::unknown);
    REQUIRE(is_positive(Tracked(1.0) / (a - a)) == Certainty::unknown);
}

TEST_CASE("square_root: given any quad, then it is right to the last bits") {
    for (const double x : {2.0, 0.1, 1e300, 1e-300, 7e22}) {
        for (const Quad y : {Quad(x), Quad(x) * Quad(x) * Quad(x), Quad(x) / 3}) {
            const Quad root = square_root(y);
            REQUIRE(is_close(root * root, y));
        }
    }
}

TEST_CASE("Oracle: given simple scenes, then the answers are known") {
    Scene scene;
    scene.geometry.add(Sphere{{0, 0, 0}, 1}, 0);
    const Oracle oracle(scene.geometry);
    const OracleAnswer ahead = oracle.closest({{0, 0, -3}, {0, 0, 2}});
    REQUIRE(ahead.kind == OracleAnswer::hit);
    REQUIRE(ahead.t == 1);
    REQUIRE(ahead.relative_error(1 + 0x1p-52) == 0x1p-52);
    REQUIRE(oracle.closest({{0, 0, 0}, {0, 0, 2}}).t == 0.5);
    REQUIRE(oracle.closest({{0, 0, 3}, {0, 0, 2}}).kind == OracleAnswer::miss);
    REQUIRE(oracle.closest({{0, 0, -3}, {0, 0, 1}, 0, 1.9}).kind == OracleAnswer::miss);
    REQUIRE(oracle.closest({{0, 0, -3}, {0, 0, 1}, 2.1, 9}).t == 4);
    REQUIRE(oracle.closest({{0, 0, -3}, {0, 0, 0}}).kind == OracleAnswer::miss);
    REQUIRE(oracle.closest({{0, 0, -3}, {0, 0, nan_value}}).kind == OracleAnswer::miss);
}

TEST_CASE(
    "Oracle: given a sector whose directions are short, then it and the kernel find it whole") {
    Scene scene;
    Profile sphere;
    sphere.squares = {1, 0, -1};
    sphere.low = -1;
    sphere.high = 1;
    const Affine map{{1, 1, 0}, {-1, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    scene.geometry.add(Revolved(map, sphere, Sector(90, {{0, -0.25}, {0, 0}})), 0);
    const Oracle oracle(scene.geometry);
    for (const Ray& ray : {Ray{{5, 0.9, 0.05}, {-1, 0, 0.01}}, Ray{{0.95, 0.9, 3}, {0, 0, -1}}}) {
        const double t = primitive_first_hit(scene.geometry, 0, RayQuery(ray));
        CHECK(t < 5);
        CHECK(oracle.closest(ray).t == Approx(t));
        const Vec3 p = ray.origin + t * ray.direction;
        CHECK(primitive_bounds(scene.geometry, 0).intersects(p));
    }
}

TEST_CASE("Oracle: its boxes around shapes of every kind enclose those of the accelerators") {
    Scene scene = mixed_scene(20);
    Random random(21);
    Profile profile;
    profile.squares = {2, -0.5, 0.25};
    profile.low = -1;
    profile.high = 2;
    for (int i = 0; i < 20; ++i) {
        const Affine map{random.in_cube(), random.in_cube(), random.in_cube(), random.in_cube()};
        scene.geometry.add(Ellipsoid(map), 0);
        scene.geometry.add(ClosedCylinder(map), 0);
        scene.geometry.add(Revolved(map, profile, Sector(30 + 10 * i)), 0);
    }
    const std::uint32_t a = scene.geometry.add_compact_vertex({0.1, 0.2, -0.3}),
                        b = scene.geometry.add_compact_vertex({1.5, 0, 0.25}),
                        c = scene.geometry.add_compact_vertex({-1, 2.5, 0.7});
    REQUIRE(scene.geometry.decimal_vertices.size() == 3);
    scene.geometry.add(Triangle{{a, b, c}}, 0);
    const Geometry& g = scene.geometry;
    for (std::uint32_t id = 0; id < g.primitives.size(); ++id) {
        const Box3 box = enclosure(g, id), tight = primitive_bounds(g, id);
        CAPTURE(id);
        for (int k = 0; k < 3; ++k) {
            CHECK(box.min[k] <= tight.min[k] + 1e-12);
            CHECK(box.max[k] >= tight.max[k] - 1e-12);
        }
    }
}

TEST_CASE(
    "Oracle: given a tangent, then it is decided where the numbers are exact, and only there") {
    Scene scene;
    scene.geometry.add(Sphere{{0, 0, 0}, 1}, 0);
    const Oracle oracle(scene.geometry);
    REQUIRE(oracle.closest({{1, 0, -3}, {0, 0, 1}}).t == 3);
    REQUIRE(oracle.closest({{1 + 0x1p-52, 0, -3}, {0, 0, 1}}).kind == OracleAnswer::miss);
    REQUIRE(oracle.closest({{1 - 0x1p-53, 0, -3}, {0, 0, 1}}).kind == OracleAnswer::hit);
}

TEST_CASE("Oracle: given equal distances, then all are named and the lowest number wins") {
    Scene scene;
    scene.geometry.add(Sphere{{0, 0, 9}, 1}, 0);
    scene.geometry.add(Plane{{0, 0, 1}, {0, 0, 1}}, 0);
    scene.geometry.add(Box{{-1, -1, 1}, {1, 1, 2}}, 0);
    scene.geometry.add(Sphere{{0, 0, 2}, 1}, 0);
    const OracleAnswer answer = Oracle(scene.geometry).closest({{0, 0, 0}, {0, 0, 1}});
    REQUIRE(answer.kind == OracleAnswer::hit);
    REQUIRE(answer.primitive == 1);
    REQUIRE(answer.tied == std::vector<HitKey>{1, 2, 3});
}

TEST_CASE("Oracle: given a root that even quad precision leaves open, then it is no tie") {
    // The box is hit at 3.2e-7, and the sphere, which the ray almost touches, at 3.164...e-7.
    Scene scene;
    scene.geometry.add(Box{{-6, -2, -1e20}, {1e20, -1.5, -128}}, 0);
    scene.geometry.add(Sphere{{1e-20, -2, -128}, 1e20}, 0);
    const OracleAnswer answer =
        Oracle(scene.geometry).closest({{1e20, -2, -1e-20}, {0, 5e-12, -4e8}});
    REQUIRE(answer.kind == OracleAnswer::undecidable);
}

TEST_CASE("Oracle: given a root that the ray's start may cut off, then it is none of the next") {
    // Both roots are within the tie distance of tmin, and further apart than the error bound of a
    // kernel's t.
    Scene scene;
    scene.geometry.add(Sphere{{0, 0, 0}, 0x1p-36}, 0);
    const Oracle oracle(scene.geometry);
    const Ray ray{{0, 0, -1}, {0, 0, 1}, 1 - 0x1p-36 - 0x1p-40};
    REQUIRE(oracle.closest(ray).kind == OracleAnswer::undecidable);
    REQUIRE(oracle.closest({ray.origin, ray.direction}).kind == OracleAnswer::hit);
}

TEST_CASE("Oracle: given an end of a cylinder known only roughly, then the ray has not passed it") {
    // In quad precision the ray begins within 1e-14 of an end of the cylinder, before or behind it,
    // but surely behind the point where its line enters the side.
    Scene scene;
    const Affine upright{{1e20, 0, 0}, {0, 3, 0}, {0, 0, 1e20}, {0, -3, -1e20}};
    scene.geometry.add(ClosedCylinder(upright), 0);
    const Ray ray{{-1e-20, -1e-20, 1e-20}, {0.4, -0.2, -0.9}};
    CHECK(Oracle(scene.geometry).closest(ray).kind == OracleAnswer::undecidable);
}

TEST_CASE("Oracle: given a root where the ray begins, then it is not taken for the one after") {
    // The line leaves the flat box at its origin, at a distance below the resolution of quad
    // precision.
    Scene scene;
    const Vec3 centre(-6.86, -1e20, 1e20), reach(1, 0, 0);
    scene.geometry.add(
        Quadric{centre, {0, 2, 1, -2, 2, 2, -2, -1, 0, 0}, {centre - reach, centre + reach}}, 0);
    const OracleAnswer answer = Oracle(scene.geometry).closest({centre, {-1e5, 0, -1e20}});
    REQUIRE(answer.kind != OracleAnswer::hit);
}

TEST_CASE("Oracle: given an instance and a direction of any length, then the ray finds the same") {
    Geometry geometry;
    geometry.objects.resize(1);
    geometry.objects[0].add(Sphere{{0, 0, 0}, 1}, 0);
    const double size = 0x1p-70;
    geometry.instances.emplace_back(Affine{{size, 0, 0}, {0, size, 0}, {0, 0, size}, Vec3(0)}, 0);
    const Oracle oracle(geometry);
    for (const int exponent : {-1000, -90, 0, 90, 950, 1000}) {
        CAPTURE(exponent);
        const Ray ray{{0, 0, -2 * size}, {0, 0, std::ldexp(1, exponent)}};
        const OracleAnswer answer = oracle.closest(ray);
        const double t = std::ldexp(size, -exponent);
        REQUIRE(answer.kind == OracleAnswer::hit);
        REQUIRE(answer.t == t);
        REQUIRE(first_hit(geometry, key_of(0, 0), ray) == t);
        REQUIRE(surface_at(geometry, ray, {t, 0, 0}).position == Vec3(0, 0, -size));
    }
}

TEST_CASE("Oracle: given many shapes, then the nearest of all single answers is the scene's") {
    const Scene scene = mixed_scene(20);
    const Oracle all(scene.geometry);
    Random random(21);
    int hits = 0;
    for (int i = 0; i < 200; ++i) {
        const Ray ray{25.0 * random.in_cube(), random.direction()};
        const OracleAnswer answer = all.closest(ray);
        if (answer.kind == OracleAnswer::undecidable) continue;
        double nearest = infinity;
        for (const Primitive p : scene.geometry.primitives) {
            Scene single = scene;
            single.geometry.primitives = PrimitiveRuns({&p, 1});
            const OracleAnswer one = Oracle(single.geometry).closest(ray);
            if (one.kind == OracleAnswer::hit) nearest = std::min(nearest, one.t);
        }
        hits += answer.kind == OracleAnswer::hit;
        CAPTURE(i);
        REQUIRE((answer.kind == OracleAnswer::hit ? answer.t : infinity) == nearest);
    }
    REQUIRE(hits > 50);
}

TEST_CASE("Oracle: given one shape alone or far from everything, then its box hides nothing") {
    // The prefilter is the one thing the oracle shares with the kernels: their bounds.
    for (const ShapeCase& shape : shape_cases()) {
        const Oracle near(shape.scene.geometry);
        Scene crowded = shape.scene;
        crowded.geometry.add(Sphere{{1e9, 1e9, 1e9}, 1},
                             0);  // a coarser margin, so more candidates
        const Oracle far(crowded.geometry);
        Random random(22);
        for (int i = 0; i < 200; ++i) {
            const Ray ray = aimed_ray(shape, i, random).ray;
            const OracleAnswer a = near.closest(ray), b = far.closest(ray);
            CAPTURE(shape.name, i);
            REQUIRE(a.kind == b.kind);
            REQUIRE(a.t == b.t);
        }
    }
}

TEST_CASE("Oracle: given rays that start on a surface exactly, then they are decided") {
    Scene scene;
    scene.geometry.add(Box{{-1, -1, -1}, {1, 1, 1}}, 0);
    const Oracle oracle(scene.geometry);
    const OracleAnswer away = oracle.closest(Ray{{0.25, 0.5, 1}, {0.1, 0.2, 1}});
    CHECK(away.kind == OracleAnswer::miss);
    const OracleAnswer through = oracle.closest(Ray{{0.25, 0.5, 1}, {0, 0, -0.5}});
    CHECK(through.kind == OracleAnswer::hit);
    CHECK(through.t == 4);
}
