// Scenes over which good hierarchies cannot be built: primitives that no split separates.
#include "bench/hard_cases/add_face.h"
#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/random_scene.h"
#include "bench/hard_cases/ray_targets.h"

namespace etalon::hard {
namespace {

/// Rays from within half a radius in all directions: no ray can leave a sphere.
CaseSetup same_spheres(std::size_t count) {
    CaseSetup setup{{}, 1, [](Random& random) {
                        const Vec3 origin = usual_place() + 0.5 * in_ball(random);
                        return Ray{origin, random.direction()};
                    }};
    while (setup.scene.geometry.primitives.size() < count) {
        setup.scene.geometry.add(Sphere{usual_place(), 1}, 0);
    }
    return setup;
}

/// Many copies of one triangle, hit by two of three rays.
CaseSetup same_triangles(std::uint32_t count) {
    CaseSetup setup{{}, 1, [](Random& random) {
                        const double x = random.uniform(), y = random.uniform();
                        const Vec3 target(x, y * (1 - x) * 1.5, 0);
                        return towards(target + 3.0 * random.direction(), target);
                    }};
    setup.scene.geometry.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (std::uint32_t i = 0; i < count; ++i) setup.scene.geometry.add(Triangle{{0, 1, 2}}, 0);
    return setup;
}

/// Concentric spheres: all centroids are equal.
CaseSetup concentric() {
    Scene scene;
    for (int i = 0; i < 500; ++i) scene.geometry.add(Sphere{usual_place(), 1 + i / 1000.0}, 0);
    return aimed_at_scene(std::move(scene));
}

/// Boxes in a row along a line.
CaseSetup in_a_row() {
    Scene scene;
    for (int i = 0; i < 1000; ++i) {
        scene.geometry.add(Box{{i + 0.0, 0, 0}, {i + 1.0, 1, 1}}, 0);
    }
    return aimed_at_scene(std::move(scene));
}

/// Every shape of a random scene eight times, with the numbers of the copies far apart.
CaseSetup copies() {
    Scene scene = random_scene({.count = 200});
    const std::vector<Primitive> once = scene.geometry.primitives.list();
    std::vector<Primitive> all = once;
    for (int copy = 1; copy < 8; ++copy) {
        all.insert(all.end(), once.begin(), once.end());
    }
    Random random(13, 0);
    for (std::size_t i = all.size() - 1; i > 0; --i) {
        std::swap(all[i], all[random.index(i + 1)]);
    }
    scene.geometry.primitives = PrimitiveRuns(all);
    return aimed_at_scene(std::move(scene));
}

/// A floor 1e6 wide, with 1e4 spheres of radius about 1e-3 in one spot; half of the rays are aimed
/// there.
CaseSetup stadium() {
    const auto near = [](Random& random) { return 0.1 * random.in_cube() + Vec3(0, 0, 0.1); };
    CaseSetup setup{{}, 1, [=](Random& random) {
                        const bool at_spot = random.index(2) == 0;
                        const Vec3 anywhere = 5e5 * Vec3(1, 1, 0) * random.in_cube();
                        const Vec3 target = at_spot ? near(random) : anywhere;
                        Vec3 out = random.direction();
                        out.z = std::abs(out.z);
                        return towards(target + random.magnitude(-2, 6) * out, target);
                    }};
    setup.scene.geometry.add(Box{{-5e5, -5e5, -1}, {5e5, 5e5, 0}}, 0);
    Random random(1, 0);
    while (setup.scene.geometry.primitives.size() < 10001) {
        const Vec3 centre = near(random);
        setup.scene.geometry.add(Sphere{centre, random.uniform(5e-4, 2e-3)}, 0);
    }
    return setup;
}

/// A scene exactly in the plane z = 0: triangles, and boxes without height.
Scene flat() {
    Scene scene;
    Random random(17, 0);
    const auto in_square = [&](double half) { return half * Vec3(1, 1, 0) * random.in_cube(); };
    while (scene.geometry.primitives.size() < 1000) {
        const Vec3 a = in_square(1), b = a + in_square(0.1);
        if (random.index(3) == 0) {
            const Vec3 half = abs(b - a);
            scene.geometry.add(Box{a - half, a + half}, 0);
        } else {
            add_face(scene, {a, b, a + in_square(0.1)});
        }
    }
    return scene;
}

/// Points on a line: no extent along two axes.
Scene spikes() {
    Scene scene;
    for (int i = 0; i < 500; ++i) scene.geometry.add(Box{{0, 0, 2.0 * i}, {0, 0, 2.0 * i + 1}}, 0);
    return scene;
}

}  // namespace

std::vector<HardCase> tree_cases() {
    Rows rows("scene");
    rows.add(
        "BVH-1", "1e4 times one sphere", [] { return same_spheres(10000); }, Criterion::enclosed);
    rows.add("BVH-1", "256 times one sphere", [] { return same_spheres(256); });
    rows.add_both("BVH-1", "256 times one triangle", [] { return same_triangles(256); });
    rows.add("BVH-1", "concentric spheres", concentric);
    rows.add("BVH-1", "boxes in a row", in_a_row);
    rows.add("BVH-1", "shuffled copies of a world", copies);
    rows.add("BVH-2", "1e4 spheres on a floor of 1e6", stadium);
    rows.add("BVH-4", "flat", [] { return aimed_at_scene(flat()); });
    rows.add("BVH-4", "boxes that are lines", [] { return aimed_at_scene(spikes()); });
    return rows.take();
}

}  // namespace etalon::hard
