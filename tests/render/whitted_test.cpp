// Whitted's trees of rays, traced together.
#include "core/integrators/whitted/secondary_rays.h"
#include "core/render/camera_sampler.h"
#include "core/sampling/dimensions.h"
#include "tests/catch.h"
#include "tests/render/test_images.h"
#include "tests/render/test_scenes.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// A scene with an instance that moves, which mirrors, shadows and absorbing glass show.
TestScene moving_scene() {
    TestScene scene = mixed_scene();
    scene.whitted().materials[2].absorption = Color(0.0F, 0.3F, 0.7F);
    scene.geometry.objects.emplace_back().add(Sphere{Vec3(0), 0.4}, 1);
    Affine start, end;
    start.origin = Vec3(-1, 0.8, 1);
    end.origin = Vec3(1, 0.8, 1);
    scene.geometry.add_moving_instance({start, end, MotionTimes{}}, 0);
    scene.camera.sees_motion = true;
    return scene;
}

/// The integrator of a scene, which must outlive it.
struct Tracer {
    explicit Tracer(const TestScene& scene)
        : sampler(scene.camera, scene.settings),
          intersector(find_backend(default_backend)->build(scene.geometry)),
          integrator(
              find_integrator("whitted")->make(scene, *intersector, scene.settings, problems)) {}

    std::vector<Color> colors(CameraBatch& batch) {
        std::vector<Color> result(batch.size());
        integrator->radiance(batch.make(integrator->uses_sources()), result, counts);
        return result;
    }

    std::vector<std::string> problems;
    CameraSampler sampler;
    std::unique_ptr<BatchIntersector> intersector;
    std::unique_ptr<Integrator> integrator;
    RayCounts counts;
};

/// Returns a surface of glass at the origin, with a normal along z.
SurfaceInteraction surface_of(const Material& material, bool entering) {
    SurfaceInteraction at;
    at.surface.position = at.surface.error = Vec3(0);
    at.surface.normal = Vec3(0, 0, 1);
    at.surface.primitive = 0;
    at.surface.convexity = Convexity::any;
    at.material = &material;
    at.entering = entering;
    at.ng = at.ns = Vec3(0, 0, entering ? 1 : -1);
    return at;
}

}  // namespace

TEST_CASE("Whitted: given other samples in its batch, then a sample has the same colour",
          "[shading]") {
    const TestScene scene = moving_scene();
    Tracer together(scene), alone(scene);
    CameraBatch batch(together.sampler), one(alone.sampler);
    for (const int count : {1000, 9, 70}) {
        batch.clear();
        std::vector<Color> expected;
        for (int i = 0; i < count; ++i) {
            const int x = i * 7 % 48, y = i * 5 % 36;
            const auto sample = static_cast<std::uint32_t>(i) % 5;
            batch.add(x, y, sample, sample + 1);
            one.clear();
            one.add(x, y, sample, sample + 1);
            expected.push_back(alone.colors(one)[0]);
        }
        CHECK(together.colors(batch) == expected);
        CHECK(together.counts == alone.counts);
    }
}

TEST_CASE("Whitted: given something that moves, then every ray of a tree sees it at one time",
          "[shading][motion]") {
    const TestScene scene = moving_scene();
    Tracer moving(scene);
    CameraBatch batch(moving.sampler);
    for (int i = 0; i < 64; ++i) batch.add(i * 3 % 48, i * 5 % 36, 1, 2);
    const std::vector<Color> colors = moving.colors(batch);
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const Imath::V2i pixel = batch.runs()[i].pixel;
        CameraBatch one(moving.sampler);
        one.add(pixel.x, pixel.y, 1, 2);
        const ShutterTime time = one.make(false).rays.times[0];
        TestScene still = scene;
        still.geometry.instances[0] = Instance(scene.geometry.motions[0].at(time), 0);
        CAPTURE(i, time);
        CHECK(Tracer(still).colors(one)[0] == colors[i]);
    }
}

TEST_CASE("Whitted: given a mirror, then rays are counted by their kinds", "[shading]") {
    TestScene scene = empty_scene(1, 1);
    Material mirror = matte(Color(0.5F));
    mirror.reflection = Color(0.5F);
    scene.whitted().materials = {mirror};
    scene.settings.max_depth = 3;
    scene.geometry.add(Sphere{Vec3(0), 1}, 0);
    scene.geometry.add(Sphere{Vec3(0, 0, 9), 1}, 0);  // behind the camera
    // The second light is hidden from the first sphere, and behind the side that this one sees of
    // the other. The ray hits the first, the other, and the first again.
    scene.whitted().lights = {PointLight{Vec3(5, 0, 5), Color(0.5F)},
                              PointLight{Vec3(0, 0, 20), Color(0.5F)}};
    RayCounts expected;
    expected.camera = expected.camera_hits = 1;
    expected.shadow = 5;
    expected.shadow_blocked = 2;
    expected.reflected = expected.secondary_hits = 2;
    CHECK(rendered(scene).counts == expected);
    scene.geometry = {};
    scene.geometry.add(Sphere{Vec3(0), 1}, 0);
    expected = {};
    expected.camera = expected.camera_hits = 1;
    expected.shadow = 2;
    expected.reflected = 1;
    CHECK(rendered(scene).counts == expected);
}

TEST_CASE("Whitted: given two lights in one place, then each has points of its own", "[shading]") {
    TestScene scene = mixed_scene();
    const QuadLight light{Vec3(-3, 4, 1), Vec3(1, 0, 0), Vec3(0, 0, 1), Color(0.5F), 9};
    scene.whitted().lights = {light, light};
    const std::vector<Color> two = image(scene);
    QuadLight bright = light;
    bright.color *= 2;
    scene.whitted().lights = {bright};
    const std::vector<Color> one = image(scene);
    double largest = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        largest = std::max<double>(largest, std::abs(one[i].y - two[i].y));
    }
    CHECK(largest > 0.05);
}

TEST_CASE("Whitted: given half of a light hidden, then half of a pixel's shadow rays are blocked",
          "[shading]") {
    TestScene scene = empty_scene(6, 4);
    scene.camera.fov_degrees = 1e-6;  // all pixels see the origin
    scene.whitted().materials = {matte(Color(1.0F))};
    scene.geometry.add(Plane{Vec3(0), Vec3(0, 0, 1)}, 0);
    scene.geometry.add(Box{Vec3(1e-5, -9, 1), Vec3(9, 9, 1.5)}, 0);
    scene.camera.eye = Vec3(-1, 0, 5);
    scene.whitted().lights = {
        QuadLight{Vec3(-2, -2, 2), Vec3(4, 0, 0), Vec3(0, 4, 0), Color(1.0F), 8}};
    for (const int samples : {1, 2, 4, 8}) {
        scene.settings.samples_per_pixel = samples;
        const RayCounts counts = rendered(scene).counts;
        CAPTURE(samples);
        CHECK(counts.shadow == 6 * 4 * 8);
        CHECK(2 * counts.shadow_blocked == counts.shadow);
    }
}

TEST_CASE("Secondary rays: given glass, then each has the path of its way", "[shading]") {
    Material material = glass(1.5);
    material.absorption = Color(0.0F, 0.25F, 0.75F);
    SeenSurfaces seen;
    seen.reset(2);
    seen.add(surface_of(material, true), Vec3(0, 0, -1), 1);
    seen.add(surface_of(material, false), Vec3(0, 0, 1), 0);
    const Color outside(0.0F), around(0.5F);
    const RayPath paths[] = {{7, 11, around}, {8, 12, outside}};
    for (const bool names : {true, false}) {
        RayCounts counts;
        SecondaryRays rays;
        rays.find(seen, paths, {}, names, counts);
        CHECK((counts.reflected == 2 && counts.refracted == 2));
        REQUIRE(rays.count == 4);
        for (std::size_t i = 0; i < 4; ++i) {
            const bool crosses = i >= 2, enters = i % 2 == 0;
            const std::uint32_t parent = enters ? 12 : 11;
            CAPTURE(names, crosses, enters);
            CHECK(rays.surfaces[i] == i % 2);
            CHECK(rays.paths[i].sample == (enters ? 8 : 7));
            CHECK(rays.paths[i].name == (names ? ray_name(parent, crosses) : parent));
            const Color& inside = enters ? material.absorption : outside;
            CHECK(rays.paths[i].absorption ==
                  (crosses ? inside : paths[enters ? 1 : 0].absorption));
        }
    }
}

TEST_CASE("Secondary rays: given total reflection, then none is refracted", "[shading]") {
    Material material = glass(1.5);
    SeenSurfaces seen;
    seen.reset(1);
    seen.add(surface_of(material, false), normalized(Vec3(3, 0, 1)), 0);
    const RayPath path{0, 1, Color(0.0F)};
    for (const bool fresnel : {false, true}) {
        material.fresnel = fresnel;
        RayCounts counts;
        SecondaryRays rays;
        rays.find(seen, {&path, 1}, {}, true, counts);
        CHECK((counts.reflected == 1 && counts.refracted == 0));
        CHECK(rays.weights[0].color() == Color(1.0F));
    }
}
