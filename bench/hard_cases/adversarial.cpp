// NaN and infinity in primitives and in rays.
#include "bench/hard_cases/add_face.h"
#include "bench/hard_cases/case_families.h"
#include "bench/hard_cases/random_scene.h"
#include "bench/hard_cases/ray_targets.h"

namespace etalon::hard {
namespace {

constexpr double none = nan_value;

void add_adversarial_spheres(Scene& scene) {
    for (const double bad : {none, infinity, -infinity}) {
        for (int k = 0; k < 3; ++k) {
            Vec3 centre(0);
            centre[k] = bad;
            scene.geometry.add(Sphere{centre, 1}, 0);
        }
        scene.geometry.add(Sphere{{0, 0, 0}, bad}, 0);
    }
    scene.geometry.add(Sphere{{0, 0, 0}, 0}, 0);
    scene.geometry.add(Sphere{{0, 0, 0}, -1}, 0);
}

void add_adversarial_cones(Scene& scene) {
    const Vec3 base(0), top(0, 0, 1);
    for (const double bad : {none, infinity, -infinity}) {
        scene.geometry.add(Cone{base, {0, bad, 1}, 1, 1}, 0);
        scene.geometry.add(Cone{{bad, 0, 0}, top, 1, 1}, 0);
        scene.geometry.add(Cone{base, top, bad, 1}, 0);
        scene.geometry.add(Cone{base, top, 1, bad}, 0);
    }
    scene.geometry.add(Cone{base, base, 1, 1}, 0);
    scene.geometry.add(Cone{base, top, 0, 0}, 0);
    scene.geometry.add(Cone{base, top, 1, -1}, 0);
}

void add_adversarial_boxes_and_planes(Scene& scene) {
    for (const double bad : {none, infinity, -infinity}) {
        scene.geometry.add(Box{{bad, -1, -1}, {1, 1, 1}}, 0);
        scene.geometry.add(Box{{-1, -1, -1}, {1, 1, bad}}, 0);
        scene.geometry.add(Plane{{0, 0, bad}, {0, 0, 1}}, 0);
        scene.geometry.add(Plane{{0, 0, 0}, {0, bad, 1}}, 0);
    }
    scene.geometry.add(Box{{1, -1, -1}, {-1, 1, 1}}, 0);
    scene.geometry.add(Box{Vec3(1), Vec3(-1)}, 0);
    scene.geometry.add(Plane{{0, 0, 0}, {0, 0, 0}}, 0);
}

void add_adversarial_rings(Scene& scene) {
    for (const double bad : {none, infinity, -infinity}) {
        scene.geometry.add(Ring{{bad, 0, 0}, {0, 0, 1}, 0, 1}, 0);
        scene.geometry.add(Ring{{0, 0, 0}, {0, bad, 1}, 0, 1}, 0);
        scene.geometry.add(Ring{{0, 0, 0}, {0, 0, 1}, bad, 1}, 0);
        scene.geometry.add(Ring{{0, 0, 0}, {0, 0, 1}, 0, bad}, 0);
    }
    scene.geometry.add(Ring{{0, 0, 0}, {0, 0, 0}, 0, 1}, 0);
    scene.geometry.add(Ring{{0, 0, 0}, {0, 0, 1}, 1, 0.5}, 0);
    scene.geometry.add(Ring{{0, 0, 0}, {0, 0, 1}, 0, 0}, 0);
}

void add_adversarial_quadrics(Scene& scene) {
    const Quadric good{{0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 1, 0, -1}, {Vec3(-1), Vec3(1)}};
    const auto add_but = [&](auto&& change) {
        Quadric s = good;
        change(s);
        scene.geometry.add(s, 0);
    };
    for (const double bad : {none, infinity, -infinity}) {
        add_but([=](Quadric& s) { s.centre.y = bad; });
        add_but([=](Quadric& s) { s.clip.min.x = bad; });
        add_but([=](Quadric& s) { s.clip.max.z = bad; });
        for (std::size_t i = 0; i < 10; ++i) add_but([=](Quadric& s) { s.coefficients[i] = bad; });
    }
    add_but([](Quadric& s) { std::swap(s.clip.min, s.clip.max); });
    add_but([](Quadric& s) { s.coefficients = {}; });
    add_but([](Quadric& s) { s.coefficients = {0, 0, 0, 0, 0, 0, 0, 0, 0, 1}; });
}

void add_adversarial_faces(Scene& scene) {
    const Vec3 a(-1, 0, 0), b(1, 0, 0), c(3, 0, 0), d(0, 1, 0);
    for (const double bad : {none, infinity, -infinity}) {
        add_face(scene, {a, b, Vec3(bad)});
        add_face(scene, {a, b, {0, bad, 0}});
        add_face(scene, {a, b, d, {0, bad, 0}});
    }
    add_face(scene, {a, a, a});
    add_face(scene, {a, b, c});
    add_face(scene, {a, b, b});
    add_face(scene, {a, a, a, a});
    add_face(scene, {a, b, c, b});
    add_face(scene, {{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}});
}

/// Returns a random scene whose first and last primitives cannot be hit; valid ones are in between.
Scene adversarial_scene() {
    Scene scene;
    const auto add_adversarial = [&scene] {
        add_adversarial_spheres(scene);
        add_adversarial_cones(scene);
        add_adversarial_boxes_and_planes(scene);
        add_adversarial_rings(scene);
        add_adversarial_quadrics(scene);
        add_adversarial_faces(scene);
    };
    add_adversarial();
    Random random(5, 0);
    while (scene.geometry.primitives.size() < 500) {
        const Vec3 centre = random.in_cube();
        scene.geometry.add(Sphere{centre, random.uniform(0.01, 0.1)}, 0);
        const Vec3 a = random.in_cube(), b = a + 0.2 * random.in_cube();
        add_face(scene, {a, b, a + 0.2 * random.in_cube()});
    }
    add_adversarial();
    return scene;
}

/// Rays at the valid primitives of the adversarial random scene.
CaseSetup among_adversarial() {
    CaseSetup setup = aimed_at_scene(adversarial_scene());
    setup.size = 1;
    return setup;
}

/// Replaces one number of a valid ray by NaN or infinity; a quarter of the rays is unchanged.
void spoil(Ray& ray, Random& random) {
    const double bad = std::array{none, infinity, -infinity}[random.index(3)];
    const int k = random.axis();
    switch (random.index(8)) {
        case 0:
            ray.origin[k] = bad;
            break;
        case 1:
            ray.direction[k] = bad;
            break;
        case 2:
            ray.direction = Vec3(random.sign() * 0.0);
            break;
        case 3:
            ray.tmin = none;
            break;
        case 4:
            ray.tmax = random.index(2) == 0 ? 0.0 : random.sign() * 0.5;
            break;
        case 5:
            std::swap(ray.tmin, ray.tmax);
            break;
        default:
            break;
    }
}

CaseSetup adversarial_rays() {
    CaseSetup setup = aimed_at_scene(random_scene({.count = 500}));
    setup.ray = [good = std::move(setup.ray)](Random& random) {
        Ray ray = good(random);
        spoil(ray, random);
        return ray;
    };
    return setup;
}

}  // namespace

std::vector<HardCase> adversarial_cases() {
    Rows rows("scene");
    rows.add("BVH-3", "adversarial primitives", among_adversarial);
    rows.add("BVH-3", "adversarial rays", adversarial_rays);
    return rows.take();
}

}  // namespace etalon::hard
