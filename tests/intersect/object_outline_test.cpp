// Bounds of objects under affine maps.
#include "core/intersect/object_outline.h"
#include "core/intersect/kernels.h"
#include "core/intersect/near_region.h"
#include "core/numerics/transforms.h"
#include "tests/catch.h"
#include "tests/intersect/rays_at_shapes.h"

using namespace etalon;

namespace {

/// Turns, mirrors and stretches by a condition of up to 1e6.
Affine any_map(Random& random) {
    const Vec3 stretch(random.magnitude(-3, 3), random.sign() * random.magnitude(-3, 3), 1);
    Affine map = rotation(random.uniform(0, 360), random.direction()) * scaling(stretch) *
                 rotation(random.uniform(0, 360), random.direction());
    map.origin = 5.0 * random.in_cube();
    return map;
}

/// Requires that a box contains the image of a point, but for the roundings of the map.
void require_contains_image(const Box3& box, const Affine& map, const Vec3& p) {
    const Vec3 image = map.point(p);
    const Vec3 terms = std::abs(p.x) * abs(map.x) + std::abs(p.y) * abs(map.y) +
                       std::abs(p.z) * abs(map.z) + abs(map.origin);
    for (int k = 0; k < 3; ++k) {
        CAPTURE(k, box.min[k], image[k], box.max[k]);
        REQUIRE(image[k] >= box.min[k] - 0x1p-50 * terms[k]);
        REQUIRE(image[k] <= box.max[k] + 0x1p-50 * terms[k]);
    }
}

Geometry of_sphere(const Sphere& sphere) {
    Geometry geometry;
    geometry.add(sphere, 0);
    return geometry;
}

/// A triangle whose corners are those given. One of them has few digits.
void add_triangle(Geometry& geometry, const Vec3& a, const Vec3& b, const Vec3& c) {
    const std::uint32_t first = geometry.add_vertex(a), second = geometry.add_vertex(b);
    geometry.add(Triangle{{first, second, geometry.add_compact_vertex(Vec3(Vec3f(c)))}}, 0);
}

/// Returns flat triangles that touch a sphere from inside, with many corners.
Geometry ball_of_triangles(const Sphere& sphere) {
    Random random(2);
    Geometry geometry;
    const auto corner = [&] { return sphere.centre + sphere.radius * random.direction(); };
    for (int i = 0; i < 3000; ++i) add_triangle(geometry, corner(), corner(), corner());
    return geometry;
}

}  // namespace

TEST_CASE("object outline: given triangles, then a box of the image contains all corners") {
    Random random(1);
    for (int i = 0; i < 3000; ++i) {
        const Vec3 centre = random.magnitude(-2, 4) * random.direction();
        const Vec3 radius(random.magnitude(-2, 2), random.magnitude(-2, 2),
                          random.magnitude(-2, 2));
        Geometry geometry;
        const auto corner = [&] { return centre + radius * random.direction(); };
        for (int j = 0; j < 5; ++j) add_triangle(geometry, corner(), corner(), corner());
        const Affine map = any_map(random);
        const Box3 image = ObjectOutline(geometry).image(map);
        for (std::uint32_t id = 0; id < geometry.primitives.size(); ++id) {
            const auto triangle = geometry.get<Triangle>(geometry.primitives[id]);
            for (const std::uint32_t number : triangle.vertices) {
                require_contains_image(image, map, geometry.vertex(number));
            }
        }
    }
}

TEST_CASE("object outline: given any shape, then a box of the image contains what is hit") {
    for (const ShapeCase& shape : shape_cases()) {
        const Geometry& geometry = shape.scene.geometry;
        const ObjectOutline outline(geometry);
        if (!is_bounded(outline.box())) continue;
        Random random(3);
        for (int i = 0; i < 300; ++i) {
            const Ray ray = aimed_ray(shape, i, random).ray;
            const double t = primitive_first_hit(geometry, 0, RayQuery(ray));
            if (!(t <= infinity)) continue;
            CAPTURE(shape.name, i);
            const Affine map = any_map(random);
            require_contains_image(outline.image(map), map,
                                   surface_at(geometry, ray, {t, 0}).position);
        }
    }
}

TEST_CASE("object outline: given a ball, then a box of the image is a sixteenth larger at most") {
    const Sphere sphere{Vec3(1000, -300, 20), 2};
    Random random(4);
    for (const Geometry& geometry : {of_sphere(sphere), ball_of_triangles(sphere)}) {
        const ObjectOutline outline(geometry);
        double largest = 0, smallest = infinity;
        for (int i = 0; i < 3000; ++i) {
            const Affine turn = rotation(random.uniform(0, 360), random.direction());
            const Vec3 size = outline.image(turn).size() / (2 * sphere.radius);
            largest = std::max(largest, max_abs(size));
            smallest = std::min({smallest, size.x, size.y, size.z});
        }
        CHECK(largest < 1 + 1.0 / 16);
        CHECK(smallest > 0.99);
    }
}

TEST_CASE("object outline: given a map along known axes, then the box of a ball is the smallest") {
    const Sphere sphere{Vec3(3, -1, 2), 2};
    const ObjectOutline outline(of_sphere(sphere));
    const std::array steps = {-1.0, -0.5, 0.0, 0.5, 1.0};
    for (const double x : steps) {
        for (const double y : steps) {
            const std::array rows = {Vec3(1, x, y), Vec3(y, -1, x), Vec3(x, y, 1)};
            const Affine map{{rows[0].x, rows[1].x, rows[2].x},
                             {rows[0].y, rows[1].y, rows[2].y},
                             {rows[0].z, rows[1].z, rows[2].z},
                             Vec3(7)};
            const Box3 image = outline.image(map);
            for (int k = 0; k < 3; ++k) {
                const double reach = sphere.radius * rows[k].length();
                CHECK(image.max[k] == Approx(map.point(sphere.centre)[k] + reach).epsilon(1e-12));
                CHECK(image.min[k] == Approx(map.point(sphere.centre)[k] - reach).epsilon(1e-12));
            }
        }
    }
}

TEST_CASE("object outline: given nothing that can be hit, then the image is empty") {
    Geometry geometry;
    CHECK(ObjectOutline(geometry).image(Affine{}).isEmpty());
    geometry.add(Sphere{Vec3(0), -1}, 0);
    CHECK(ObjectOutline(geometry).image(Affine{}).isEmpty());
}

TEST_CASE("object outline: given numbers without a bound, then the image is everywhere") {
    const double s = 0x1p1000, m = 0x1p-1074;
    Geometry plane, denormal;
    plane.add(Plane{Vec3(0), Vec3(1, 0, 0)}, 0);
    add_triangle(denormal, m * Vec3(1025, 1024, 1024), m * Vec3(-1025, -1024, -1024), Vec3(0));
    for (const Geometry& geometry : {plane, denormal, of_sphere({Vec3(0), 0x1p1020})}) {
        CHECK(ObjectOutline(geometry).image(Affine{}).max.x == infinity);
    }
    const ObjectOutline huge(of_sphere({Vec3(0x1p999), 0x1p990}));
    CHECK(huge.image(Affine{}).max.x < infinity);
    CHECK(huge.image({{s, s, 0}, {-s, s, 0}, {0, 0, s}}).max.x == infinity);
}

TEST_CASE("object outline: given a map to a line, then the image has no thickness") {
    const ObjectOutline outline(of_sphere({Vec3(1, 2, 3), 2}));
    const Box3 image = outline.image({Vec3(0), Vec3(0, 5, 0), Vec3(0), Vec3(7)});
    CHECK((image.min.x == 7 && image.max.x == 7));
    CHECK((image.min.z == 7 && image.max.z == 7));
    CHECK(image.min.y == Approx(7));
    CHECK(image.max.y == Approx(5 * 4 + 7));
}
