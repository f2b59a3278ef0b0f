// Sorting of a scene's primitives for accelerators.
#include "core/intersect/bounded.h"
#include "core/numerics/random.h"
#include "core/parallel/parallel.h"
#include "core/scene/scene.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

constexpr std::uint32_t count = 20'000;

/// Spheres, with a plane for every seventh, and for every fifth of those left a sphere that is not
/// there.
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
