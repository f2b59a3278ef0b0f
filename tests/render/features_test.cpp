#include "core/render/features.h"

#include "core/parallel/parallel.h"
#include "core/render/camera_sampler.h"
#include "core/shading/fresnel.h"
#include "core/shading/physical_shading.h"
#include "tests/catch.h"
#include "tests/render/lens_camera.h"
#include "tests/render/pbrt_scene.h"
#include "tests/render/test_images.h"
#include "tests/render/test_scenes.h"

using namespace etalon;
using namespace etalon::test;

namespace {

CentreParametrizations parametrizations_of(const TestScene& scene) {
    const auto intersector = find_backend(default_backend)->build(scene.geometry);
    return centre_parametrizations(scene, *intersector, scene.settings).value();
}

CentreHits hits_of(const TestScene& scene) {
    const auto intersector = find_backend(default_backend)->build(scene.geometry);
    return centre_hits(scene, *intersector, scene.settings).value();
}

SurfaceMeans means_of(const TestScene& scene) {
    const auto intersector = find_backend(default_backend)->build(scene.geometry);
    std::vector<std::string> problems;
    std::optional<PhysicalShading> shading;
    if (scene.is_physical()) shading.emplace(scene, problems);
    return surface_means(scene, *intersector, scene.settings, shading ? &*shading : nullptr)
        .value();
}

/// A scene of purely diffuse materials with a black background.
TestScene without_light(TestScene scene) {
    for (Material& m : scene.whitted().materials) m = matte(m.diffuse);
    scene.whitted().lights.clear();
    scene.whitted().environment.background = Color(0.0F);
    return scene;
}

/// The same with surfaces that emit their albedo, so that the image shows the albedo.
TestScene glowing(TestScene scene) {
    for (Material& m : scene.whitted().materials) std::swap(m.ambient, m.diffuse);
    return scene;
}

}  // namespace

TEST_CASE("A centre hit is where arithmetic has it; a miss is at infinity", "[features]") {
    TestScene scene = empty_scene(3, 3);
    scene.whitted().materials = {matte(Color(0.5F))};
    scene.geometry.add(Plane{Vec3(0, -100, 0), Vec3(0, 1, 0)}, 0);
    scene.geometry.add(Sphere{Vec3(0), 1}, 0);
    const CentreHits hits = hits_of(scene);
    REQUIRE(hits.depths.size() == 9);
    CHECK(hits.positions[4] == Vec3f(0, 0, 1));
    CHECK(hits.depths[4] == 4.0F);
    CHECK(hits.primitives[4] == 1);
    CHECK(hits.positions[0] == Vec3f(0));
    CHECK(hits.depths[0] == std::numeric_limits<float>::infinity());
    CHECK(hits.primitives[0] == no_index);
    CHECK(hits.primitives[8] == 0);
}

TEST_CASE("Surface coordinates are those of the hit; a miss has none", "[features]") {
    TestScene scene = empty_scene(3, 3);
    scene.whitted().materials = {matte(Color(0.5F))};
    scene.geometry.add(Box{Vec3(-1, -0.5, -1), Vec3(1, 1.5, 0)}, 0);
    const CentreParametrizations p = parametrizations_of(scene);
    REQUIRE(p.uv.size() == 9);
    CHECK(p.uv[4] == Imath::V2f(0.5F, 0.25F));
    CHECK(p.dpdu[4] == Vec3f(2, 0, 0));
    CHECK(p.dpdv[4] == Vec3f(0, 2, 0));
    CHECK(p.uv[0] == Imath::V2f(0));
    CHECK(p.dpdu[0] == Vec3f(0));
    CHECK(p.dpdv[0] == Vec3f(0));
}

TEST_CASE("Surface coordinates of a mesh are its own", "[features]") {
    const TestScene scene = pbrt_scene(
        "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point P\" [-1 -1 0  1 -1 0  "
        "1 1 0  -1 1 0] \"float uv\" [0 0 1 0 1 1 0 1]");
    const CentreParametrizations p = parametrizations_of(scene);
    const CentreHits hits = hits_of(scene);
    for (std::size_t i = 0; i < p.uv.size(); ++i) {
        REQUIRE(hits.primitives[i] != no_index);
        CHECK(p.uv[i].x == Approx((hits.positions[i].x + 1) / 2).margin(1e-6));
        CHECK(p.uv[i].y == Approx((hits.positions[i].y + 1) / 2).margin(1e-6));
        CHECK((p.dpdu[i] - Vec3f(2, 0, 0)).length() < 1e-6F);
        CHECK((p.dpdv[i] - Vec3f(0, 2, 0)).length() < 1e-6F);
    }
}

TEST_CASE("Features are of what is seen through surfaces of the null material", "[features]") {
    const std::string ball = "Material \"matte\" \"rgb Kd\" [0.75 0.5 0.25] Shape \"sphere\"\n";
    const TestScene alone = pbrt_scene(ball);
    const TestScene inside =
        pbrt_scene(ball + "Material \"none\" Shape \"sphere\" \"float radius\" 2\n");
    const CentreHits expected = hits_of(alone), hits = hits_of(inside);
    CHECK(hits.positions == expected.positions);
    CHECK(hits.depths == expected.depths);
    CHECK(hits.primitives == expected.primitives);
    CHECK(parametrizations_of(inside).uv == parametrizations_of(alone).uv);
    CHECK(means_of(inside).normal.pixels() == means_of(alone).normal.pixels());
    const std::vector<Color> albedo = means_of(inside).albedo.pixels();
    CHECK(albedo == std::vector(albedo.size(), Color(0.75F, 0.5F, 0.25F)));
}

TEST_CASE("Depth is along the axis of view, the position on the pixel's ray there", "[features]") {
    const TestScene scene = mixed_scene();
    const CentreHits hits = hits_of(scene);
    const Imath::V2i& size = scene.settings.resolution;
    const CameraRays camera(scene.camera, size);
    int found = 0;
    for (int i = 0; i < size.x * size.y; ++i) {
        if (hits.primitives[i] == no_index) continue;
        const Vec2 pixel(i % size.x + 0.5, i / size.x + 0.5);
        const Ray ray = camera.ray(pixel, Vec2(0.5));
        const Vec3 expected = ray.origin + hits.depths[i] / -ray.direction.z * ray.direction;
        CHECK((Vec3(hits.positions[i]) - expected).length() < 1e-5 * hits.depths[i]);
        ++found;
    }
    CHECK(found > 1000);
}

TEST_CASE("The cost of the backend none is every primitive for every ray", "[features]") {
    const TestScene scene = mixed_scene(8, 6);
    const auto intersector = find_backend(reference_backend)->build(scene.geometry);
    const CentreHits hits = centre_hits(scene, *intersector, scene.settings).value();
    for (const TraversalCost& cost : hits.costs) {
        CHECK(cost.primitive_tests == scene.geometry.primitives.size());
        CHECK(cost.box_tests == 0);
    }
}

TEST_CASE("Albedo is the sum of reflection and transmission, at most 1", "[features]") {
    TestScene scene = empty_scene(1, 1);
    Material m = matte(Color(0.5F, 0.25F, 0.0F));
    m.reflection = Color(0.25F, 0.0F, 0.0F);
    m.transmission = Color(0.5F, 0.25F, 0.0F);
    m.ambient = m.specular = Color(9.0F);
    scene.whitted().materials = {m};
    scene.geometry.add(Plane{Vec3(0), Vec3(0, 0, 1)}, 0);
    CHECK(means_of(scene).albedo.pixels()[0] == Color(1.0F, 0.5F, 0.0F));
}

TEST_CASE("Normals are those for shading and face who looks", "[features]") {
    TestScene scene = empty_scene(1, 1);
    scene.whitted().materials = {matte(Color(1.0F))};
    scene.geometry.vertices = {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 2, 0)};
    const Vec3 leaning = Vec3(-0.6, 0, 0.8);
    scene.geometry.normals = {leaning, leaning, leaning};
    scene.geometry.add(Triangle{{0, 1, 2}, 0}, 0);
    const Vec3 front(means_of(scene).normal.pixels()[0]);
    CHECK((front - leaning).length() < 1e-6);
    scene.camera.eye.z = -5;
    const Vec3 back(means_of(scene).normal.pixels()[0]);
    CHECK((back + leaning).length() < 1e-6);
}

TEST_CASE("Means are over the first 16 of the image's own samples", "[features]") {
    TestScene scene = without_light(mixed_scene());
    const auto [samples, pictured] = GENERATE(std::pair(5, 5), std::pair(40, 16));
    scene.settings.samples_per_pixel = pictured;
    const std::vector<Color> expected = image(glowing(scene));
    scene.settings.samples_per_pixel = samples;
    CHECK(means_of(scene).albedo.pixels() == expected);
}

TEST_CASE("The albedo of glass is of the light from where it is seen", "[features]") {
    TestScene scene = pbrt_scene(
        "Material \"glass\" \"rgb Kr\" [0 0 0] \"rgb Kt\" [1 1 1] \"float eta\" 1.5 "
        "Shape \"sphere\" \"float radius\" 0.2");
    scene.settings.samples_per_pixel = 0;
    const SurfaceMeans means = means_of(scene);
    const CameraRays camera(scene.camera, scene.settings.resolution);
    int seen = 0;
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            const std::size_t pixel = means.normal.index(x, y);
            const Vec3 normal = means.normal.mean(pixel);
            if (normal == Vec3(0)) continue;
            ++seen;
            const double cosine =
                -camera.ray(Vec2(x + 0.5, y + 0.5), Vec2(0.5)).direction.dot(normal);
            CHECK(means.albedo.mean(pixel).x ==
                  Approx(1 - fresnel_dielectric(1 / 1.5, cosine).reflectance).epsilon(1e-4));
        }
    }
    CHECK(seen > 50);
}

TEST_CASE("Rays that a lens blocks see nothing", "[features]") {
    TestScene scene = empty_scene(30, 12);
    scene.whitted().materials = {matte(Color(1.0F))};
    scene.geometry.add(Sphere{Vec3(0), 9}, 0);  // around the camera
    scene.camera = camera_with(Lens::system, false);
    scene.settings.samples_per_pixel = 16;
    const std::vector<Color> albedo = means_of(scene).albedo.pixels();
    const CameraSampler sampler(scene.camera, scene.settings);
    int blocked = 0;
    for (int i = 0; i < 30 * 12; ++i) {
        CameraBatch batch(sampler);
        batch.add(i % 30, i / 30, 0, 16);
        const auto weights = batch.make(false).weights;
        const auto passing = 16 - std::ranges::count(weights, 0.0F);
        CHECK(albedo[i].x == static_cast<float>(passing) / 16);
        blocked += passing < 16;
    }
    CHECK(blocked > 50);
}

TEST_CASE("Means use the rays of an image without samples", "[features]") {
    TestScene scene = without_light(mixed_scene());
    scene.settings.samples_per_pixel = 0;
    scene.settings.pixel_rays =
        GENERATE(PixelRays::centre, PixelRays::upper_left, PixelRays::shared_corners);
    const SurfaceMeans means = means_of(scene);
    CHECK(means.albedo.pixels() == image(glowing(scene)));
    CHECK(means.normal.window() == scene.settings.window());
}

TEST_CASE("A crop's features are those of the whole, on any number of threads", "[features]") {
    TestScene scene = mixed_scene();
    const SurfaceMeans means = means_of(scene);
    const CentreHits hits = hits_of(scene);
    const CentreParametrizations coordinates = parametrizations_of(scene);
    const std::vector<Color> normals = means.normal.pixels();
    scene.settings.crop = {{7, 5}, {30, 30}};
    for (const int threads : {1, 2}) {
        const ThreadLimit limit(threads);
        const std::vector<Color> part = means_of(scene).normal.pixels();
        const CentreHits part_hits = hits_of(scene);
        const CentreParametrizations part_coordinates = parametrizations_of(scene);
        std::size_t i = 0;
        for (int y = 5; y <= 30; ++y) {
            for (int x = 7; x <= 30; ++x, ++i) {
                const int j = y * scene.settings.resolution.x + x;
                REQUIRE(part[i] == normals[j]);
                REQUIRE(part_hits.positions[i] == hits.positions[j]);
                REQUIRE(part_coordinates.uv[i] == coordinates.uv[j]);
                REQUIRE(part_hits.costs[i].box_tests == hits.costs[j].box_tests);
            }
        }
        CHECK(part.size() == i);
    }
}

TEST_CASE("A stop leaves no features rather than parts of them", "[features]") {
    const TestScene scene = mixed_scene();
    const std::atomic<bool> stop = true;
    const auto intersector = find_backend(default_backend)->build(scene.geometry);
    CHECK_FALSE(surface_means(scene, *intersector, scene.settings, nullptr, &stop));
    CHECK_FALSE(centre_hits(scene, *intersector, scene.settings, &stop));
    CHECK_FALSE(centre_parametrizations(scene, *intersector, scene.settings, &stop));
}
