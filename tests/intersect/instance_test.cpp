// The transformation of rays and points between world space and object space.
#include "core/intersect/instance_bounds.h"
#include "core/intersect/kernels.h"
#include "core/intersect/placement.h"
#include "core/numerics/transforms.h"
#include "core/oracle/oracle.h"
#include "core/test_rays/directions.h"
#include "tests/catch.h"
#include "tests/intersect/rays_at_shapes.h"

using namespace etalon;

namespace {

Affine random_map(Random& random, double condition) {
    const double root = std::sqrt(condition);
    Affine map = rotation(random.uniform(0, 360), random.direction()) *
                 scaling({1 / root, -1, root}) *
                 rotation(random.uniform(0, 360), random.direction());
    map.origin = 3.0 * random.in_cube();
    return map;
}

/// A unit sphere under a map.
Geometry sphere_under(const Affine& map) {
    Geometry geometry;
    geometry.objects.resize(1);
    geometry.objects[0].add(Sphere{{0, 0, 0}, 1}, 7);
    geometry.instances.emplace_back(map, 0);
    return geometry;
}

/// Hits a shape under random maps next to an edge, and spawns a ray into it, which must hit it
/// again from inside. `on_edge` and `inside` return random points of the shape.
template <class Shape, class OnEdge, class Inside>
void require_exits_from_inside(const Shape& shape, const OnEdge& on_edge, const Inside& inside) {
    Random random(9);
    Geometry geometry;
    geometry.objects.resize(1);
    geometry.objects[0].add(shape, 0);
    geometry.instances.emplace_back(Affine{}, 0);
    for (int i = 0; i < 20000; ++i) {
        const Affine map = random_map(random, random.magnitude(0, 4));
        geometry.instances[0] = Instance(map, 0);
        const Vec3 target = on_edge(random) + random.magnitude(-18, -12) * random.direction();
        const Vec3 from = map.point(4.0 * random.direction());
        const Ray ray{from, map.point(target) - from};
        const double t = first_hit(geometry, key_of(0, 0), ray);
        if (!(t <= infinity)) continue;
        const SurfacePoint p = surface_at(geometry, ray, {t, 0, 0});
        const Ray left = spawn_ray(p, map.point(inside(random)) - p.position);
        const double next = first_hit(geometry, key_of(0, 0), left);
        CAPTURE(i, t, next);
        REQUIRE((next > 0 && next < infinity));
        REQUIRE(surface_at(geometry, left, {next, 0, 0}).normal.dot(left.direction) > 0);
    }
}

}  // namespace

TEST_CASE("Instance: given a map, then points and directions are taken back by its inverse") {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const double condition = random.magnitude(0, 4);
        const Affine map = random_map(random, condition);
        const Instance instance(map, 0);
        const Vec3 local = random.in_cube(), direction = random.direction();
        const Ray ray = to_object(instance, 0, Ray{map.point(local), map.vector(direction), 1, 2});
        const double tolerance = 64 * condition * unit_roundoff;
        CAPTURE(i, condition);
        REQUIRE(max_abs(ray.origin - local) < tolerance);
        REQUIRE(max_abs(ray.direction - direction) < tolerance);
        REQUIRE((ray.tmin == 1 && ray.tmax == 2 && ray.exclude == no_index));
    }
}

TEST_CASE("Instance: given an object far from the world's origin, then nothing cancels") {
    const Vec3 far(1e9, -3e9, 2e9);
    Affine map = rotation(30, {1, 2, 3});
    map.origin = far;
    const Instance instance(map, 0);
    const Vec3 local(0.25, -0.5, 0.125), world = far + map.vector(local);
    const Vec3 exact = world - far;  // the rounded world space point relative to it
    const Affine back = rotation(-30, {1, 2, 3});
    CHECK(max_abs(to_object(instance, world) - back.vector(exact)) < 1e-15);
}

TEST_CASE("Instance: given a scale by a power of two, then hits have the same bits") {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const Affine map = random_map(random, 100);
        const Ray ray{5.0 * random.in_cube(), random.direction()};
        const double k = 0x1p-13;
        const Affine smaller{k * map.x, k * map.y, k * map.z, k * map.origin};
        const Ray nearer{k * ray.origin, k * ray.direction};
        const Ray a = to_object(Instance(map, 0), 0, ray);
        const Ray b = to_object(Instance(smaller, 0), 0, nearer);
        REQUIRE((a.origin == b.origin && a.direction == b.direction));
    }
}

TEST_CASE("Instance: given a map that is singular or not finite, then nothing is hit") {
    for (const Affine& map : {scaling({1, 0, 1}), scaling({1, nan_value, 1}), scaling({0, 0, 0}),
                              translation({infinity, 0, 0})}) {
        CHECK_FALSE(Instance(map, 0).exists());
        const Geometry geometry = sphere_under(map);
        CHECK(instance_bounds(geometry, {}).boxes.front().isEmpty());
    }
    CHECK(Instance(scaling({1e-100, 1e-100, 1e-100}), 0).exists());
    CHECK(Instance(scaling({1e100, 1, 1e-100}), 0).exists());
}

TEST_CASE("Instance: given a hit, then its point is on the image, with the image's normal") {
    Random random(3);
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        const Affine map = random_map(random, random.magnitude(0, 4));
        const Geometry geometry = sphere_under(map);
        const Vec3 from = map.point(4.0 * random.direction());
        const Ray ray{from, map.point(random.in_cube()) - from};
        const OracleAnswer answer = Oracle(geometry).closest(ray);
        if (answer.kind != OracleAnswer::hit) continue;
        ++hits;
        REQUIRE((answer.instance == 0 && answer.primitive == 0));
        const SurfacePoint p = surface_at(geometry, ray, {answer.t, 0, 0});
        const Vec3 local = to_object(geometry.instances[0], p.position);
        CAPTURE(i);
        REQUIRE(std::abs(local.length() - 1) < 1e-11);
        REQUIRE((p.material == 7 && p.instance == 0));
        const Vec3 tangent = map.vector(local.cross(random.direction()));
        REQUIRE(std::abs(p.normal.dot(normalized(tangent))) < 1e-10);
        REQUIRE(p.normal.dot(p.position - map.origin) > 0);  // outward, though the map mirrors
        const Parametrization at = parametrization_at(geometry, p);
        REQUIRE(std::abs(p.normal.dot(normalized(at.dpdu))) < 1e-10);
    }
    CHECK(hits > 300);
}

TEST_CASE("Instance: given any condition number, then the point of a hit is where the ray is") {
    Random random(6);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const double condition = random.magnitude(0, 12);
        const Affine map = random_map(random, condition);
        const Geometry geometry = sphere_under(map);
        const double size = max_abs(map.x) + max_abs(map.y) + max_abs(map.z);
        const Vec3 from = map.origin + 4 * size * random.direction();
        const Ray ray{from, map.point(random.in_cube()) - from};
        const double t = first_hit(geometry, key_of(0, 0), ray);
        if (!(t <= infinity)) continue;
        ++hits;
        const SurfacePoint p = surface_at(geometry, ray, {t, 0, 0});
        CAPTURE(i, condition);
        REQUIRE(max_abs(p.position - (ray.origin + t * ray.direction)) <
                64 * unit_roundoff * condition * (size + max_abs(from)));
    }
    CHECK(hits > 500);
}

TEST_CASE("Instance: given a ray that leaves one outward, then it does not hit it again") {
    Random random(4);
    int leaving = 0, again = 0;
    for (int i = 0; i < 20000; ++i) {
        Affine map = random_map(random, random.magnitude(0, 4));
        map.origin = random.magnitude(0, 7) * random.direction();
        const Geometry geometry = sphere_under(map);
        const Instance& instance = geometry.instances[0];
        const Vec3 from = map.point(2.0 * random.direction());
        const Ray ray{from, map.point(random.in_cube()) - from};
        const double t = first_hit(geometry, key_of(0, 0), ray);
        if (!(t < infinity)) continue;
        const SurfacePoint p = surface_at(geometry, ray, {t, 0, 0});
        Vec3 direction = random.direction();
        if (p.normal.dot(direction) < 0) direction = -direction;
        const Vec3 local = to_object(instance, spawn_origin(p, direction));
        // Outside the surface as computed by the kernel, so that a ray outwards does not hit it.
        again += !(local.dot(local) > 1);
        again += first_hit(geometry, key_of(0, 0), spawn_ray(p, direction)) < infinity;
        ++leaving;
    }
    CHECK(leaving > 10000);
    CHECK(again == 0);
}

TEST_CASE("Instance: given a ray into a box from next to an edge, then it hits it from inside") {
    const Box box{{-1, -0.5, -0.75}, {0.5, 1, 0.25}};
    const auto on_edge = [&](Random& random) {
        Vec3 corner = random.index(2) == 0 ? box.min : box.max;
        corner[random.axis()] = random.uniform(-0.4, 0.2);
        return corner;
    };
    require_exits_from_inside(box, on_edge, [](Random& random) { return 0.25 * in_ball(random); });
}

TEST_CASE(
    "Instance: given a ray into a cylinder from next to a rim, then it meets it from inside") {
    Random random(8);
    for (int i = 0; i < 8; ++i) {
        const Affine of_cylinder = random_map(random, random.magnitude(0, 1));
        const auto on_rim = [&](Random& choice) {
            const double angle = choice.uniform(0, 6.283185307179586);
            return of_cylinder.point(
                {std::cos(angle), std::sin(angle), static_cast<double>(choice.index(2))});
        };
        require_exits_from_inside(ClosedCylinder(of_cylinder), on_rim, [&](Random& choice) {
            return of_cylinder.point(Vec3(0, 0, 0.5) + 0.25 * in_ball(choice));
        });
    }
}

TEST_CASE("Instance: given any map, then its box encloses the object, and is tight") {
    Random random(5);
    for (int i = 0; i < 300; ++i) {
        const Affine map = random_map(random, random.magnitude(0, 3));
        const Geometry geometry = sphere_under(map);
        const Box3 box = instance_bounds(geometry, {}).boxes.front();
        for (int k = 0; k < 100; ++k) {
            REQUIRE(box.intersects(map.point(random.direction())));
        }
        for (int k = 0; k < 3; ++k) {
            const double needed = std::hypot(map.x[k], map.y[k], map.z[k]);
            REQUIRE(box.size()[k] / 2 < (1 + 1.0 / 16 + 1e-3) * needed);
        }
    }
}

TEST_CASE("Instance: given an object without a bound, then neither has its instance one") {
    Geometry geometry = sphere_under({});
    geometry.objects[0].add(Plane{{0, 0, 0}, {0, 0, 1}}, 0);
    CHECK(instance_bounds(geometry, {}).boxes.front().max.x == infinity);
}

TEST_CASE("Instance: given a ray without a direction, then it hits nothing") {
    const Geometry geometry = sphere_under({});
    CHECK(std::isnan(first_hit(geometry, key_of(0, 0), Ray{Vec3(0), Vec3(0)})));
    CHECK(std::isnan(first_hit(geometry, key_of(0, 0), Ray{Vec3(0), Vec3(infinity)})));
}
