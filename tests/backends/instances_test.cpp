// Instances: every exact backend finds the hits that the kernels find for rays transformed to
// object space.
#include "bench/hard_cases/hard_case.h"
#include "core/intersect/kernels.h"
#include "core/intersect/placement.h"
#include "core/numerics/transforms.h"
#include "core/scene/transformed.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Returns the hit among all primitives and those of all instances, by the rule for ties.
Hit all_tested(const Geometry& geometry, const Ray& ray) {
    Hit best{ray.tmax, no_index};
    const auto offer = [&](std::uint32_t primitive, std::uint32_t instance) {
        const double t = first_hit(geometry, key_of(primitive, instance), ray);
        const bool is_first = best.primitive == no_index && t <= ray.tmax && t < infinity;
        if (is_first || t < best.t) best = {t, primitive, instance};
    };
    for (std::uint32_t p = 0; p < geometry.primitives.size(); ++p) offer(p, no_index);
    for (std::uint32_t i = 0; i < geometry.instances.size(); ++i) {
        if (!geometry.instances[i].exists()) continue;
        for (std::uint32_t p = 0; p < geometry.holder(i).primitives.size(); ++p) offer(p, i);
    }
    return best;
}

std::vector<Ray> rays_of(const hard::CaseSetup& setup, std::uint64_t count) {
    std::vector<Ray> rays;
    for (std::uint64_t i = 0; i < count; ++i) {
        Random random(9, i);
        rays.push_back(setup.ray(random));
    }
    return rays;
}

/// Counts rays for which any query of the backend differs from `expected`.
std::size_t count_wrong(const Backend& backend, const Geometry& geometry,
                        const std::vector<Ray>& rays, const std::vector<Hit>& expected) {
    const auto intersector = backend.build(geometry);
    std::vector<Hit> hits(rays.size());
    std::vector<std::uint8_t> blocked(rays.size());
    intersector->closest(rays, hits);
    intersector->occluded(rays, blocked);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool is_hit = expected[i].primitive != no_index;
        const Hit alone = intersector->closest(rays[i]).value_or(Hit{0, no_index});
        TraversalCost cost;
        const Hit counted = intersector->closest(rays[i], cost).value_or(Hit{0, no_index});
        wrong += !same(hits[i], expected[i]) || !same(alone, expected[i]) ||
                 !same(counted, expected[i]) || (blocked[i] != 0) != is_hit ||
                 intersector->occluded(rays[i]) != is_hit;
    }
    return wrong;
}

/// Compares all exact backends with the kernels. Returns the number of rays that hit.
int check_all(const Geometry& geometry, const std::vector<Ray>& rays) {
    std::vector<Hit> expected;
    for (const Ray& ray : rays) expected.push_back(all_tested(geometry, ray));
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        CHECK(count_wrong(backend, geometry, rays, expected) == 0);
    }
    return static_cast<int>(
        std::ranges::count_if(expected, [](const Hit& hit) { return hit.primitive != no_index; }));
}

template <class Visit>
void for_each_case(const Visit& visit) {
    for (const hard::HardCase& c : hard::hard_cases()) {
        if (!c.id.starts_with("INST") || c.criterion == hard::Criterion::enclosed) continue;
        INFO(c.id << ", " << c.variant);
        visit(c.make());
    }
}

}  // namespace

TEST_CASE("Given instances, exact backends find what the kernels find", "[instances]") {
    for_each_case([](const hard::CaseSetup& setup) {
        const Geometry& geometry = setup.scene.geometry;
        const std::vector<Ray> rays = rays_of(setup, 400);
        std::vector<Hit> expected;
        for (const Ray& ray : rays) expected.push_back(all_tested(geometry, ray));
        for (const Backend& backend : exact_backends()) {
            INFO("backend " << backend.name);
            CHECK(count_wrong(backend, geometry, rays, expected) == 0);
        }
    });
}

TEST_CASE("Given rays that say what they left of an instance, they hit what others hit",
          "[instances]") {
    std::size_t excluding = 0;
    for_each_case([&](const hard::CaseSetup& setup) {
        const Geometry& geometry = setup.scene.geometry;
        Random random(10);
        std::vector<Ray> rays;
        std::vector<Hit> expected;
        for (const Ray& ray : rays_of(setup, 400)) {
            const Hit hit = all_tested(geometry, ray);
            if (hit.primitive == no_index) continue;
            Ray leaving = spawn_ray(surface_at(geometry, ray, hit), random.direction());
            rays.push_back(leaving);
            excluding += leaving.exclude != no_index;
            leaving.exclude = no_index;
            expected.push_back(all_tested(geometry, leaving));
        }
        for (const Backend& backend : exact_backends()) {
            INFO("backend " << backend.name);
            CHECK(count_wrong(backend, geometry, rays, expected) == 0);
        }
    });
    CHECK(excluding > 1000);
}

TEST_CASE("Given a ray that excludes a primitive of an instance, it hits that of the next",
          "[instances]") {
    Geometry geometry;
    for (const double size : {1.0, 2.0}) {
        Geometry& object = geometry.objects.emplace_back();
        object.vertices = {{-size, -size, 0}, {size, -size, 0}, {0, size, 0}};
        object.add(Triangle{{0, 1, 2}}, 0);
    }
    for (std::uint32_t i = 0; i < 6; ++i) {
        geometry.instances.emplace_back(Affine{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, double(i)}},
                                        i % 2);
    }
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        const auto intersector = backend.build(geometry);
        for (std::uint32_t i = 0; i < 6; ++i) {
            Ray ray{{0, 0, i - 0.5}, {0, 0, 1}};
            CHECK(intersector->closest(ray)->instance == i);
            ray.exclude = key_of(0, i);
            const auto hit = intersector->closest(ray);
            CHECK(hit.has_value() == (i < 5));
            if (hit) CHECK(hit->instance == i + 1);
            CHECK(intersector->occluded(ray) == (i < 5));
        }
    }
}

TEST_CASE("Given instances in a scene scaled by a power of two, hits are the same", "[instances]") {
    for_each_case([](const hard::CaseSetup& setup) {
        const double k = 0x1p-9;
        const Scene small = transformed(setup.scene, k);
        for (const Backend& backend : exact_backends()) {
            if (backend.name == "none") continue;
            const auto large = backend.build(setup.scene.geometry);
            const auto scaled = backend.build(small.geometry);
            for (Ray ray : rays_of(setup, 200)) {
                const Hit a = large->closest(ray).value_or(Hit{0, no_index});
                ray.origin *= k, ray.direction *= k;
                CHECK(same(scaled->closest(ray).value_or(Hit{0, no_index}), a));
            }
        }
    });
}

TEST_CASE("Given a primitive and instances at the same distance, the primitive wins",
          "[instances]") {
    Geometry geometry;
    geometry.objects.resize(2);
    for (Geometry& object : geometry.objects) {
        object.add(Sphere{{0, 0, 5}, 1}, 0);
        object.add(Sphere{{0, 0, 0}, 1}, 0);
        object.add(Sphere{{0, 0, 0}, 1}, 0);
    }
    for (const std::uint32_t object : {1, 0, 1}) geometry.instances.emplace_back(Affine{}, object);
    const Ray ray{{0, 0, -3}, {0, 0, 1}};
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        const auto only_instances = backend.build(geometry);
        CHECK(same(only_instances->closest(ray).value(), {2, 1, 0}));
        Geometry with_primitive = geometry;
        with_primitive.add(Sphere{{0, 0, 0}, 1}, 0);
        CHECK(same(backend.build(with_primitive)->closest(ray).value(), {2, 0}));
    }
}

TEST_CASE("Given an instance just before a primitive, it is found after that", "[instances]") {
    Geometry geometry;
    geometry.add(Box{{-1, -1, 0}, {1, 1, 1}}, 0);
    geometry.objects.resize(1);
    geometry.objects[0].add(Box{{-1, -1, 0}, {1, 1, 0}}, 0);
    geometry.instances.emplace_back(Affine{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -0x1p-32}}, 0);
    Random random(32);
    std::vector<Ray> rays;
    std::vector<Hit> expected;
    for (int i = 0; i < 500; ++i) {
        const Vec3 origin = Vec3(0, 0, -3) + random.in_cube();
        rays.push_back({origin, 0.5 * random.in_cube() - origin});
        expected.push_back(all_tested(geometry, rays.back()));
        REQUIRE(expected.back().instance == 0);
    }
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        CHECK(count_wrong(backend, geometry, rays, expected) == 0);
    }
}

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

TEST_CASE("Given instances of empty objects, nothing is hit", "[instances]") {
    Geometry geometry;
    geometry.objects.resize(1);
    geometry.instances.assign(3, Instance(Affine{}, 0));
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        CHECK_FALSE(backend.build(geometry)->closest(Ray{{0, 0, -3}, {0, 0, 1}}));
    }
}

TEST_CASE("Given thousands of objects, every backend builds them and finds each", "[instances]") {
    constexpr std::uint32_t count = 2000;
    Geometry geometry;
    geometry.objects.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        geometry.objects[i].add(Sphere{Vec3(0), 0.25}, 0);
        geometry.instances.emplace_back(Affine{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {double(i), 0, 0}},
                                        i);
    }
    for (const Backend& backend : exact_backends()) {
        INFO("backend " << backend.name);
        const auto intersector = backend.build(geometry);
        for (std::uint32_t i = 0; i < count; i += 97) {
            const auto hit = intersector->closest(Ray{{double(i), 0, -3}, {0, 0, 1}});
            REQUIRE(hit);
            CHECK(hit->instance == i);
            CHECK(hit->t == 2.75);
        }
    }
}
