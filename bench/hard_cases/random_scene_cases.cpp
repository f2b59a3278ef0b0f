// Whole scenes compared with brute force: errors of backends rather than of kernels.
#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/random_scene.h"
#include "bench/hard_cases/ray_targets.h"
#include "core/scene/transformed.h"

namespace etalon::hard {
namespace {

/// Returns spheres in a cube of edge 2 around a point, with float coordinates.
Scene cloud(const Vec3& place) {
    Scene scene;
    Random random(1, 0);
    while (scene.geometry.primitives.size() < 2000) {
        const Vec3 centre = rounded(place + random.in_cube());
        scene.geometry.add(Sphere{centre, static_cast<float>(random.uniform(0.01, 0.04))}, 0);
    }
    return scene;
}

/// Rays from all around, half of them within 1e-3 radii of silhouettes, the others anywhere.
CaseSetup cloud_from(double offset, double distance) {
    const Vec3 place = offset * Vec3(0.6, -0.48, 0.64);
    CaseSetup setup{cloud(place), 1, {}};
    setup.ray = [=, spheres = setup.scene.geometry.all<Sphere>()](Random& random) {
        const Vec3 eye = place + distance * random.direction();
        if (random.index(2) == 0) return towards(eye, place + random.in_cube());
        const Sphere& s = spheres[random.index(spheres.size())];
        const Vec3 side = across((s.centre - eye).normalized(), random.uniform(0, turn));
        const double reach = s.radius * (1 + random.uniform(-1e-3, 1e-3));
        return towards(eye, s.centre + reach * side);
    };
    return setup;
}

void add_clouds(Rows& rows) {
    struct Offset {
        const char* name;
        double offset;
    };
    for (const Offset& o : {Offset{"0", 0}, Offset{"1e3", 1e3}, Offset{"1e5", 1e5}}) {
        for (const int distance : {3, 300, 30000}) {
            const std::string from = " from " + std::to_string(distance);
            rows.add_both("A4", std::string("cloud at ") + o.name + from,
                          [offset = o.offset, distance] { return cloud_from(offset, distance); });
        }
    }
}

/// Returns thin triangles of random orientations.
Scene slivers() {
    Scene scene;
    Random random(16, 0);
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const Vec3 a = random.in_cube(), along = random.in_cube();
        const double share = random.uniform(), width = random.magnitude(-8, -2);
        const Vec3 c = a + share * along + width * random.in_cube();
        scene.geometry.vertices.insert(scene.geometry.vertices.end(), {a, a + along, c});
        scene.geometry.add(Triangle{{3 * i, 3 * i + 1, 3 * i + 2}}, 0);
    }
    return scene;
}

Scene one_kind(ShapeKind kind) {
    return random_scene({.count = kind == kind_of<Plane>() ? 20U : 1000U, .kinds = {kind}});
}

}  // namespace

std::vector<HardCase> random_scene_cases() {
    Rows rows("scene");
    add_clouds(rows);
    rows.add("A4", "mixed: from an eye", [] { return camera_rays_of(random_scene({}), 3); });
    rows.add("A4", "mixed: bouncing", [] { return bouncing_in_scene(random_scene({})); });
    rows.add("A4", "mixed: aimed", [] { return aimed_at_scene(random_scene({})); });
    rows.add("A4", "mixed: aimed to the last bit",
             [] { return aimed_at_scene(random_scene({}), to_the_last_bit); });
    for (ShapeKind kind = 0; kind < shape_kinds; ++kind) {
        rows.add("A4", std::string(kind_name(kind)) + " only: aimed",
                 [=] { return aimed_at_scene(one_kind(kind)); });
    }
    rows.add("A4", "one-sided: aimed",
             [] { return aimed_at_scene(random_scene({.one_sided = true})); });
    rows.add("A4", "huge and tiny: aimed", [] {
        return aimed_at_scene(random_scene({.count = 200, .smallest = 1e-6, .largest = 1e4}));
    });
    rows.add("A4", "slivers: aimed", [] { return aimed_at_scene(slivers()); });
    const auto add_moved = [&](const char* name, double factor, const Vec3& offset) {
        rows.add("A4", name,
                 [=] { return aimed_at_scene(transformed(random_scene({}), factor, offset)); });
    };
    add_moved("mixed at 1e6: aimed", 1, {1e6, -1e6, 1e6});
    add_moved("minute, 1e-30: aimed", 1e-30, Vec3(0));
    add_moved("immense, 1e30: aimed", 1e30, Vec3(0));
    return rows.take();
}

}  // namespace etalon::hard
