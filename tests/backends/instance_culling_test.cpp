// Boxes of instances: no exact backend culls what the kernels hit.
#include <array>

#include "core/numerics/random.h"
#include "core/numerics/transforms.h"
#include "tests/backends/instance_checks.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Instances of one box with sizes from 1e-7 to 10, each at place(size, random).
template <class Place>
Geometry boxes_of_all_sizes(int count, const Place& place) {
    Geometry geometry;
    geometry.objects.resize(1);
    geometry.objects[0].add(Box{{-1, -1, -1}, {1, 1, 1}}, 0);
    Random random(31);
    for (int i = 0; i < count; ++i) {
        const double size = random.magnitude(-7, 1);
        const Affine map{{size, 0, 0}, {0, size, 0}, {0, 0, size}, place(size, random)};
        geometry.instances.emplace_back(map, 0);
    }
    return geometry;
}

Geometry anywhere() {
    return boxes_of_all_sizes(400, [](double, Random& random) { return random.in_cube(10); });
}

Geometry about_one_place() {
    return boxes_of_all_sizes(1000, [](double size, Random& random) {
        return Vec3(3, -4, 5) + 4 * size * random.direction();
    });
}

/// About more places than there are trees that `embree` may visit first.
Geometry about_twelve_places() {
    std::array<Vec3, 12> centres;
    Random at(30);
    for (Vec3& centre : centres) centre = at.in_cube(1000);
    return boxes_of_all_sizes(3000, [&](double size, Random& random) {
        return centres[random.index(centres.size())] + 30 * size * random.direction();
    });
}

Affine any_instance(const Geometry& geometry, Random& random) {
    return geometry.instances[random.index(geometry.instances.size())].to_world();
}

Vec3 point_at_edge(const Affine& instance, Random& random) {
    Vec3 place;
    for (int k = 0; k < 3; ++k) place[k] = random.one_in(5) ? random.uniform(-1, 1) : random.sign();
    return instance.point(place);
}

/// Returns a ray at an edge of an instance's box, from a few or very many sizes away.
Ray ray_at_edge(const Geometry& geometry, Random& random) {
    const Affine instance = any_instance(geometry, random);
    const double distance = instance.x.x * random.magnitude(0, 9);
    Vec3 offset;
    for (int k = 0; k < 3; ++k) offset[k] = random.uniform(-1, 1) * (random.one_in(3) ? 1e-9 : 1);
    const Vec3 target = point_at_edge(instance, random), origin = target + distance * offset;
    return {origin, origin == target ? offset : target - origin};
}

}  // namespace

TEST_CASE("Given instances of all sizes and rays at their edges, none is culled that is hit",
          "[instances]") {
    using Make = Geometry (*)();
    const Make make = GENERATE(as<Make>(), anywhere, about_one_place, about_twelve_places);
    const Geometry geometry = make();
    Random random(32);
    std::vector<Ray> rays;
    for (int i = 0; i < 4000; ++i) rays.push_back(ray_at_edge(geometry, random));
    CHECK(check_all(geometry, rays) > 1000);
}

TEST_CASE("Given instances of all sizes and rays from one to another, none is culled that is hit",
          "[instances]") {
    const Geometry geometry = about_twelve_places();
    Random random(36);
    std::vector<Ray> rays;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 origin = point_at_edge(any_instance(geometry, random), random);
        rays.push_back({origin, point_at_edge(any_instance(geometry, random), random) - origin});
    }
    CHECK(check_all(geometry, rays) > 1000);
}

namespace {

/// Returns instances of a cube that are flattened or stretched between two rotations.
Geometry cubes_of_condition(double condition, Random& random) {
    const auto turn = [&] { return rotation(random.uniform(0, 360), random.direction()); };
    Geometry geometry;
    geometry.objects.resize(1);
    geometry.objects[0].add(Box{Vec3(-1), Vec3(1)}, 0);
    for (int i = 0; i < 8; ++i) {
        const double thin = 1 / condition, other = i % 2 == 0 ? 1 : thin;
        Affine map = turn() * scaling({1, thin, other}) * turn();
        map.origin = 2.0 * random.in_cube();
        geometry.instances.emplace_back(map, 0);
    }
    return geometry;
}

/// Returns a ray that passes an instance's most extreme corner along an axis, `outside` of it, from
/// a distance. Both are in units of the instance's size.
Ray ray_at_extreme(const Geometry& geometry, double distance, double outside, Random& random) {
    const Affine map = geometry.instances[random.index(geometry.instances.size())].to_world();
    const int k = random.axis();
    const double side = random.sign();
    const auto corner = [&](double along) { return std::copysign(1.0, side * along); };
    const Vec3 row(map.x[k], map.y[k], map.z[k]);
    Vec3 target = map.point({corner(row.x), corner(row.y), corner(row.z)}),
         way = random.direction();
    target[k] += side * outside * sum_abs(row);
    way[k] = 0;
    return {target - distance * sum_abs(row) * normalized(way), normalized(way)};
}

}  // namespace

TEST_CASE("Given instances under maps of any condition number, none is culled that is hit",
          "[instances]") {
    int hits = 0;
    for (const double condition : {1e2, 1e4, 1e5, 1e6, 1e7, 1e8, 1e10, 1e12, 1e13, 1e14}) {
        CAPTURE(condition);
        Random random(33);
        const Geometry geometry = cubes_of_condition(condition, random);
        std::vector<Ray> rays;
        for (int i = 0; i < 600; ++i) {
            const double inside = random.magnitude(-12, 0);
            rays.push_back(ray_at_extreme(geometry, random.uniform(1, 5), -inside, random));
        }
        hits += check_all(geometry, rays);
    }
    CHECK(hits > 1000);
}

TEST_CASE("Given instances of a large spread and rays from far away, none is culled that is hit",
          "[instances]") {
    int hits = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        Random random(34, seed);
        Geometry geometry = cubes_of_condition(3e5, random);
        geometry.instances.resize(1, geometry.instances[0]);
        std::vector<Ray> rays;
        for (int i = 0; i < 200; ++i) {
            const double outside = random.uniform(0, 5e-4);
            rays.push_back(ray_at_extreme(geometry, random.uniform(8e6, 1.2e7), outside, random));
        }
        hits += check_all(geometry, rays);
    }
    CHECK(hits > 30);
}

TEST_CASE(
    "Given tiny instances of a large spread and rays from far away, none is culled that is hit",
    "[instances]") {
    constexpr double size = 1e-4;
    Geometry geometry;
    geometry.add(Box{{3, 3, 3}, {4, 4, 4}}, 0);
    geometry.objects.resize(1);
    geometry.objects[0].add(Box{Vec3(-1), Vec3(1)}, 0);
    Random random(35);
    for (int i = 0; i < 20; ++i) {
        for (const Instance& cube : cubes_of_condition(1e3, random).instances) {
            geometry.instances.emplace_back(scaling(Vec3(size)) * cube.to_world(), 0);
        }
    }
    std::vector<Ray> rays;
    for (int i = 0; i < 2000; ++i) {
        const double distance = random.magnitude(6, 11), outside = random.magnitude(-8, -2);
        rays.push_back(ray_at_extreme(geometry, distance, outside, random));
    }
    CHECK(check_all(geometry, rays) > 30);
}
