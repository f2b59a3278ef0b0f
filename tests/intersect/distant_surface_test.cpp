// Points of hits by rays from so far away that o + t d says nothing about the place on the shape.
#include "core/intersect/shapes/thickness.h"

#include "core/intersect/kernels.h"
#include "tests/catch.h"
#include "tests/intersect/rays_at_shapes.h"

using namespace etalon;

namespace {

/// A line along an axis at a shape. Rays on it differ in one coordinate of the origin.
struct AxisLine {
    AxisLine(const ShapeCase& shape, Random& random)
        : axis(random.axis()), is_aimed(random.one_in(2)) {
        ray.direction = Vec3(0);
        ray.direction[axis] = random.sign() * random.magnitude(-3, 3);
        const Target& target = shape.targets[random.index(shape.targets.size())];
        const Vec3 from = shape.centre - 10 * shape.size * unit_vector(ray.direction);
        ray.origin = target.point(random, from);
        if (!is_aimed) ray.origin += 0.1 * shape.size * random.in_cube();
    }

    Ray starting_before(const Vec3& centre, double distance) const {
        Ray moved = ray;
        moved.origin[axis] = centre[axis] - std::copysign(distance, ray.direction[axis]);
        return moved;
    }

    Ray ray;
    int axis;
    bool is_aimed;  ///< at a rim, a tip or a silhouette, where roundings of the origin matter
};

bool depends_on_place(const Geometry& geometry) {
    return with_shape(geometry.primitives[0].kind,
                      []<class Shape>() { return HasThickness<Shape>; });
}

}  // namespace

TEST_CASE("Surfaces: given a ray from any distance, its point is the one seen from nearby") {
    for (const ShapeCase& shape : shape_cases()) {
        const Geometry& geometry = shape.scene.geometry;
        if (!depends_on_place(geometry)) continue;
        CAPTURE(shape.name);
        Random random(23);
        int hits = 0;
        for (int i = 0; i < 600; ++i) {
            const AxisLine line(shape, random);
            const Ray close = line.starting_before(shape.centre, 8 * shape.size);
            const Ray distant =
                line.starting_before(shape.centre, shape.size * random.magnitude(10, 200));
            const double t = primitive_first_hit(geometry, 0, RayQuery(close)),
                         far_t = primitive_first_hit(geometry, 0, RayQuery(distant));
            if (!(t <= infinity && far_t <= infinity)) continue;
            const SurfacePoint expected = surface_at(geometry, close, {t, 0}),
                               found = surface_at(geometry, distant, {far_t, 0});
            CAPTURE(i, distant.origin, distant.direction, t, far_t);
            CAPTURE(expected.position, found.position, expected.normal, found.normal);
            REQUIRE(std::abs(found.normal.length() - 1) < 1e-14);
            ++hits;
            if (line.is_aimed) continue;
            REQUIRE(max_abs(found.normal - expected.normal) < 1e-5);
            REQUIRE(max_abs(found.position - expected.position) < 1e-5 * shape.size);
        }
        CHECK(hits > 50);
    }
}

TEST_CASE("Surfaces: given a distant ray that passed a sphere's front, its point is behind") {
    Geometry geometry;
    geometry.add(Sphere{{1, 2, 3}, 0.5}, 0);
    const Ray front{{0x1p36, 2.25, 3.125}, {-1, 0, 0}};
    const double first = primitive_first_hit(geometry, 0, RayQuery(front));
    Ray behind = front;
    behind.tmin = first;
    const double second = primitive_first_hit(geometry, 0, RayQuery(behind));
    REQUIRE(second > first);
    CHECK(surface_at(geometry, front, {first, 0}).normal.x > 0.5);
    CHECK(surface_at(geometry, behind, {second, 0}).normal.x < -0.5);
}

TEST_CASE("Surfaces: given a ray that leaves a needle from inside, its point is ahead of it") {
    Geometry geometry;
    geometry.add(Cone{{0, 0, -1}, {0, 0, 1}, 1e-10, 1e-10}, 0);
    geometry.add(Ellipsoid({{1, 0, 0}, {0, 1, 0}, {0, 0, 1e-10}, Vec3(0)}), 0);
    for (const auto& [primitive, ray] : {std::pair(0U, Ray{Vec3(0), {1.25e-10, 0, 1}}),
                                         std::pair(1U, Ray{Vec3(0), {1, 0, 9e-11}})}) {
        const double t = primitive_first_hit(geometry, primitive, RayQuery(ray));
        REQUIRE(t < infinity);
        const SurfacePoint p = surface_at(geometry, ray, {t, primitive});
        CHECK(p.normal.dot(ray.direction) > 0);
        CHECK(max_abs(p.position - t * ray.direction) < 1e-9);
    }
}
