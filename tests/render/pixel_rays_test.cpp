// Images without samples: the directions of their rays, and the counts of the SPD benchmark.
#include "core/formats/load.h"
#include "core/integrators/whitted/whitted.h"
#include "core/render/camera_rays.h"
#include "tests/catch.h"
#include "tests/formats/shared_scenes.h"
#include "tests/render/test_images.h"
#include "tests/render/test_scenes.h"

using namespace etalon;
using namespace etalon::test;

namespace {

TestScene scene_with(PixelRays rays) {
    TestScene scene = mixed_scene(12, 9);
    scene.settings.samples_per_pixel = 0;
    scene.settings.pixel_rays = rays;
    return scene;
}

/// Returns the colour that a ray through the point `pixel` of the image sees.
Color seen_through(const TestScene& scene, const Vec2& pixel) {
    const auto intersector = find_backend(reference_backend)->build(scene.geometry);
    std::vector<std::string> problems;
    RayCounts counts;
    const CameraRays camera(scene.camera, scene.settings.resolution);
    const Ray ray = camera.ray(pixel, Vec2(0.5));
    const SampleSource sample({0, 0, 0}, 0);
    RayBuffer rays;
    rays.make_room(1);
    rays.set(0, ray);
    Color color;
    Whitted(scene, *intersector, scene.settings, problems)
        .radiance({rays.view(1), {&sample, 1}}, {&color, 1}, counts);
    return color;
}

RayCounts counts_of(const TestScene& scene) {
    return rendered(scene).counts;
}

/// A ball that transmits half of the light and reflects none.
TestScene clear_ball() {
    TestScene scene = empty_scene();
    Material clear;
    clear.transmission = Color(0.5F);
    clear.ior = 1.25;
    scene.whitted().materials = {clear};
    scene.geometry.add(Sphere{Vec3(0), 1}, 0);
    return scene;
}

}  // namespace

TEST_CASE("the one ray of a pixel goes through its centre or its upper left corner", "[render]") {
    const TestScene centres = scene_with(PixelRays::centre),
                    corners = scene_with(PixelRays::upper_left);
    const std::vector<Color> a = image(centres), b = image(corners);
    for (const auto& [x, y] : {std::pair(0, 0), {5, 4}, {11, 8}, {3, 7}}) {
        CHECK(a[y * 12 + x] == seen_through(centres, {x + 0.5, y + 0.5}));
        CHECK(b[y * 12 + x] == seen_through(corners, Vec2(x, y)));
    }
}

TEST_CASE("a pixel of shared corners is the mean of its four", "[render]") {
    const TestScene scene = scene_with(PixelRays::shared_corners);
    const std::vector<Color> pixels = image(scene);
    REQUIRE(pixels.size() == 12 * 9);
    for (const auto& [x, y] : {std::pair(0, 0), {5, 4}, {11, 8}, {3, 7}}) {
        Vec3 sum(0);
        for (const auto& [dx, dy] : {std::pair(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
            sum += Vec3(seen_through(scene, Vec2(x + dx, y + dy)));
        }
        CHECK(pixels[y * 12 + x] == Color(sum / 4.0));
    }
}

TEST_CASE("a shared corner is traced once", "[render]") {
    CHECK(counts_of(scene_with(PixelRays::shared_corners)).camera == 13 * 10);
    CHECK(counts_of(scene_with(PixelRays::centre)).camera == 12 * 9);
}

TEST_CASE("a crop of shared corners holds the same pixels as the whole", "[render]") {
    TestScene scene = scene_with(PixelRays::shared_corners);
    const std::vector<Color> all = image(scene);
    scene.settings.crop = {{7, 2}, {11, 6}};
    const std::vector<Color> part = image(scene);
    REQUIRE(part.size() == 5 * 5);
    for (int i = 0; i < 25; ++i) CHECK(part[i] == all[(2 + i / 5) * 12 + 7 + i % 5]);
}

TEST_CASE("where all glass mirrors, a reflected ray of no weight is counted", "[render]") {
    TestScene scene = clear_ball();
    const RayCounts without = counts_of(scene);
    const std::vector<Color> pixels = image(scene);
    CHECK(without.reflected == 0);
    CHECK(without.refracted > 0);
    scene.settings.whitted.mirror_all_glass = true;
    const RayCounts with = counts_of(scene);
    CHECK(with.reflected >= with.refracted);
    CHECK(with.refracted > without.refracted);  // rays reflected inside also leave
    CHECK(image(scene) == pixels);
}

TEST_CASE("eyes' rays made to fit keep their hue", "[render]") {
    TestScene scene = empty_scene();
    scene.whitted().environment.background = Color(0.5F, 1.0F, 4.0F);
    CHECK(centre(scene) == Color(0.5F, 1.0F, 4.0F));
    scene.settings.whitted.normalize_camera_rays = true;
    CHECK(centre(scene) == Color(0.125F, 0.25F, 1.0F));
    scene.whitted().environment.background = Color(0.5F, 0.25F, 0.75F);
    CHECK(centre(scene) == Color(0.5F, 0.25F, 0.75F));
}

TEST_CASE("the real SPD scenes take the published numbers of rays",
          "[render][needs_shared_scenes]") {
    struct Published {
        std::string name;
        std::uint64_t hits, shadow, reflected, refracted;  ///< of the README or of GOLEM
    };
    const Published table[] = {{"balls", 263169, 954368, 175095, 0},
                               {"gears", 245332, 2246955, 304643, 207564 - 7594},
                               {"mount", 173685, 412922, 354769, 354769},
                               {"teapot_s12", 161546, 407656, 225248, 0},
                               {"tetra", 49950, 46262, 0, 0}};
    const auto near = [](std::uint64_t count, std::uint64_t published) {
        return Approx(static_cast<double>(published)).epsilon(0.01) == static_cast<double>(count);
    };
    for (const Published& p : table) {
        const std::string path = shared_scene("nff", p.name);
        SKIP_UNLESS(std::filesystem::exists(path), path << " does not exist");
        LoadResult loaded = load_scene(path);
        TestScene scene{std::move(*loaded.scene), loaded.settings};
        scene.settings.pixel_rays = PixelRays::shared_corners;
        scene.settings.whitted.mirror_all_glass = true;
        const RayCounts counts = counts_of(scene);
        CAPTURE(path, counts.shadow, counts.reflected, counts.refracted);
        CHECK(counts.camera == 513 * 513);
        CHECK(counts.camera_hits <= p.hits + 1);
        CHECK(counts.camera_hits >= p.hits);
        CHECK(near(counts.shadow, p.shadow));
        CHECK(near(counts.reflected, p.reflected));
        CHECK(near(counts.refracted, p.refracted));
    }
}
