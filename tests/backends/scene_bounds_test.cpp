// Sorting of a scene's primitives for accelerators.
#include "core/intersect/bounded.h"
#include "core/numerics/random.h"
#include "core/parallel/parallel.h"
#include "core/scene/scene.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

constexpr std::uint32_t count = 20'000;

/// Returns spheres, of which every seventh is replaced by a plane, and every fifth of the rest by a
/// degenerate sphere.
Scene scene_of_all_sorts() {
    Scene scene;
    Random random(1);
    for (std::uint32_t id = 0; id < count; ++id) {
        const Vec3 place = random.in_cube();
        if (id % 7 == 0) {
            scene.geometry.add(Plane{place, random.direction()}, 0);
        } else {
            scene.geometry.add(Sphere{id % 5 == 0 ? Vec3(nan_value) : place, 0.01}, 0);
        }
    }
    return scene;
}

}  // namespace

TEST_CASE("Given any number of threads, primitives are sorted in the order of the scene") {
    const Scene scene = scene_of_all_sorts();
    for (const int threads : {1, 2, 7}) {
        const ThreadLimit limit(threads);
        const SceneBounds found = SceneBounds::of(scene.geometry);
        std::vector<std::uint32_t> bounded, planes;
        for (std::uint32_t id = 0; id < count; ++id) {
            if (id % 7 == 0) planes.push_back(id);
            if (id % 7 != 0 && id % 5 != 0) bounded.push_back(id);
        }
        CHECK(found.unbounded == planes);
        REQUIRE(found.bounded.size() == bounded.size());
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < bounded.size(); ++i) {
            const BoundedPrimitive& p = found.bounded[i];
            const Vec3 centre = found.space.point(
                scene.geometry.all<Sphere>()[scene.geometry.primitives[p.id].index].centre);
            const bool around = Box3(Vec3(p.min), Vec3(p.max)).intersects(centre);
            wrong += p.id != bounded[i] || p.kind != kind_of<Sphere>() || !around;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("Primitives that reach far beyond all others are not bounded, unless most do") {
    for (const double size : {1.0, 0x1p-80, 0x1p60}) {
        for (const std::size_t far : {0U, 1U, 16U, 17U, 10'000U, 10'001U}) {
            Scene scene;
            Random random(2);
            for (std::uint32_t id = 0; id < 10'000; ++id) {
                scene.geometry.add(Sphere{size * random.in_cube(), size * 0.01}, 0);
            }
            std::vector<std::uint32_t> outliers;
            for (std::uint32_t i = 0; i < far; ++i) {
                outliers.push_back(static_cast<std::uint32_t>(scene.geometry.primitives.size()));
                scene.geometry.add(Sphere{size * 1e23 * random.in_cube(), size}, 0);
            }
            const SceneBounds found = SceneBounds::of(scene.geometry);
            if (far > 10'000) outliers.clear();
            CHECK(found.unbounded == (far <= 16 ? outliers : std::vector<std::uint32_t>()));
            CHECK(found.far == (far > 16 ? outliers : std::vector<std::uint32_t>()));
            CHECK(found.bounded.size() + outliers.size() == scene.geometry.primitives.size());
            if (far <= 10'000) CHECK(found.space.scale() * size > 0.125);
        }
    }
}

TEST_CASE("A few primitives are outliers where their reach would blur many small ones") {
    const auto bounds_of = [](double size_of_ground, double size_of_spheres, const Vec3& place) {
        Scene scene;
        Random random(5);
        for (int i = 0; i < 1000; ++i) {
            scene.geometry.add(Sphere{place + random.in_cube(), size_of_spheres}, 0);
        }
        scene.geometry.add(Sphere{place - Vec3(0, 0, size_of_ground), size_of_ground}, 0);
        return SceneBounds::of(scene.geometry);
    };
    for (const Vec3& place : {Vec3(0), Vec3(5e5, 4e6, 0)}) {
        CHECK(bounds_of(10, 0.01, place).unbounded.empty());
        CHECK(bounds_of(1000, 0.1, place).unbounded.empty());
        CHECK(bounds_of(2000, 0.01, place).unbounded == std::vector<std::uint32_t>{1000});
    }
}

TEST_CASE("A far instance leaves the others their place in normalized space") {
    Scene scene;
    Geometry object;
    object.add(Sphere{Vec3(0), 1}, 0);
    scene.geometry.objects.push_back(std::move(object));
    for (const Vec3& place : {Vec3(0), Vec3(3, 0, 0), Vec3(0, 1e20, 0)}) {
        Affine map;
        map.origin = place;
        scene.geometry.instances.push_back(Instance(map, 0));
    }
    const SceneBounds found = SceneBounds::of(scene.geometry);
    CHECK(found.unbounded == std::vector<std::uint32_t>{2});
    REQUIRE(found.bounded.size() == 2);
    CHECK(found.bounded[0].max.x < found.bounded[1].min.x);
}

TEST_CASE("Rays from beyond all resolution that pass the scene by are known to miss") {
    Scene scene;
    Random random(3);
    for (int i = 0; i < 100; ++i) scene.geometry.add(Sphere{random.in_cube(), 0.1}, 0);
    const NormalizedSpace space = SceneBounds::of(scene.geometry).space;
    std::size_t missing = 0;
    for (int i = 0; i < 10'000; ++i) {
        const Vec3 origin = random.magnitude(9, 100) * random.direction();
        REQUIRE_FALSE(space.resolves({origin, random.direction()}));
        missing += space.surely_misses({origin, random.direction()});
        const Vec3 there = scene.geometry.all<Sphere>()[random.index(100)].centre;
        CHECK_FALSE(space.surely_misses({origin, there - origin}));
        CHECK_FALSE(space.surely_misses({origin, 1e-200 * (there - origin)}));
    }
    CHECK(missing > 9'900);
}

TEST_CASE("The reach of a space holds the box of all, though its centre is rounded") {
    const double far = 0x1p40, ulp = 0x1p-12;
    const NormalizedSpace space(Box3(Vec3(far), Vec3(far + 3 * ulp)));
    const Vec3 low = space.point(Vec3(far)), high = space.point(Vec3(far + 3 * ulp));
    const Vec3 reach = space.scale() * space.reach();
    for (int k = 0; k < 3; ++k) CHECK(reach[k] > std::max(high[k], -low[k]));
}

TEST_CASE("A ray from so far away that its products overflow is not known to miss") {
    Scene scene;
    scene.geometry.add(Sphere{Vec3(0), 1e-155}, 0);
    const NormalizedSpace space = SceneBounds::of(scene.geometry).space;
    const Ray ray{Vec3(2.5e153, 2e153, 1.5e153), Vec3(-5, -4, -3)};
    CHECK_FALSE(space.surely_misses(ray));
}
