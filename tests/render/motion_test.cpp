// Motion while the shutter is open, of the camera, shapes and instances.
#include "core/light/scene_radius.h"
#include "core/render/camera_sampler.h"
#include "core/scene/transformed.h"
#include "tests/render/pbrt_scene.h"
#include "tests/render/test_images.h"

using namespace etalon;
using namespace etalon::test;
using Catch::Matchers::WithinAbs;

namespace {

const std::string turn =
    "ActiveTransform EndTime Rotate 40 0 1 0 Translate 3 0 0 ActiveTransform All ";

/// A black square in front of uniform light, which covers the view when the shutter opens and has
/// left it to the right after an eighth of the motion.
const std::string leaving_square =
    "LightSource \"infinite\" Material \"matte\" \"rgb Kd\" [0 0 0] "
    "ActiveTransform EndTime Translate 8 0 0 ActiveTransform All "
    "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] "
    "\"point P\" [-1 -1 0 1 -1 0 1 1 0 -1 1 0]";

/// Returns a moving camera where its transform is `to_world`, at rest.
Camera still_at(const Affine& to_world, Camera camera) {
    camera.projective->motion.reset();
    camera.projective->to_world = to_world;
    return camera;
}

double mean_of(const TestScene& scene) {
    double sum = 0;
    const std::vector<Color> pixels = image(scene);
    for (const Color& pixel : pixels) sum += pixel.y;
    return sum / static_cast<double>(pixels.size());
}

std::vector<Ray> rays_of_pixel(const TestScene& scene, std::uint32_t count) {
    const CameraSampler sampler(scene.camera, scene.settings);
    CameraBatch batch(sampler);
    batch.add(3, 4, 0, count);
    const RayStream stream = batch.make(false).rays;
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < stream.size(); ++i) rays.push_back(stream[i]);
    return rays;
}

}  // namespace

TEST_CASE("A PBRT shape that moves is the one moving instance of an object", "[motion]") {
    const TestScene scene =
        pbrt_scene("Shape \"sphere\" " + turn + "Shape \"disk\" Shape \"cone\"");
    const Geometry& g = scene.geometry;
    CHECK(scene.camera.sees_motion);
    REQUIRE((g.primitives.size() == 1 && g.objects.size() == 2 && g.motions.size() == 2));
    REQUIRE((g.instances.size() == 2 && g.instances[1].motion == 1));
    CHECK(g.objects[1].primitives.size() == 1);
    CHECK(g.motions[0].at_part(0) == Affine{});
    CHECK(g.motions[0].at_part(1).origin.x == Approx(3 * std::cos(40 * M_PI / 180)));
}

TEST_CASE("A PBRT object's instances move, and need not", "[motion]") {
    const TestScene scene = pbrt_scene("ObjectBegin \"o\" Shape \"sphere\" ObjectEnd " + turn +
                                       "ObjectInstance \"o\" Identity ObjectInstance \"o\"");
    const Geometry& g = scene.geometry;
    REQUIRE((g.objects.size() == 1 && g.instances.size() == 2 && g.motions.size() == 1));
    CHECK((g.instances[0].moves() && !g.instances[1].moves()));
}

TEST_CASE("A shape that the shutter sees at one moment only stands still there", "[motion]") {
    const std::string camera =
        "TransformTimes 0 2 Camera \"perspective\" \"float fov\" 4 \"float shutteropen\" ";
    for (const auto& [shutter, x] : {std::pair("1 \"float shutterclose\" 1", 4.0),
                                     std::pair("2 \"float shutterclose\" 3", 8.0),
                                     std::pair("-3 \"float shutterclose\" 0", 0.0)}) {
        const TestScene scene = pbrt_scene(leaving_square, camera + shutter);
        CAPTURE(shutter);
        CHECK_FALSE(scene.camera.sees_motion);
        REQUIRE((scene.geometry.primitives.size() == 2 && scene.geometry.instances.empty()));
        CHECK(scene.geometry.vertices[0].x == x - 1);
    }
}

TEST_CASE("A shutter that closes before it opens is one with its times exchanged", "[motion]") {
    const TestScene scene = pbrt_scene(leaving_square,
                                       "Camera \"perspective\" \"float fov\" 4 "
                                       "\"float shutteropen\" 0.5 \"float shutterclose\" 0.25");
    CHECK(scene.geometry.motions.at(0).at(0).origin.x == 2);
}

TEST_CASE("A pixel is covered for the share of the time that something is before it", "[motion]") {
    CHECK_THAT(mean_of(pbrt_scene(leaving_square)), WithinAbs(0.875, 4e-3));
    const TestScene twice = pbrt_scene(
        leaving_square, "Camera \"perspective\" \"float fov\" 4 \"float shutterclose\" 0.5");
    CHECK_THAT(mean_of(twice), WithinAbs(0.75, 4e-3));
}

TEST_CASE("The radius of a scene is that of all that moves, at any time", "[motion]") {
    const auto radius = [](const std::string& world) {
        return scene_radius(pbrt_scene(world).geometry);
    };
    const std::string moved = "ActiveTransform EndTime Translate 0 0 100 ActiveTransform All ";
    CHECK_THAT(radius("Shape \"sphere\""), WithinAbs(std::sqrt(3), 1e-6));
    CHECK_THAT(radius(moved + "Shape \"sphere\""), WithinAbs(std::hypot(1, 1, 51), 0.1));
    CHECK_THAT(radius("Rotate 90 1 0 0 " + moved + "Shape \"disk\""),
               WithinAbs(std::hypot(1, 50, 1), 0.1));
    CHECK(radius("ActiveTransform EndTime Rotate 180 0 1 0 ActiveTransform All "
                 "Translate 0 0 10 Shape \"sphere\"") > 11);
}

TEST_CASE("In media too, what moves far away keeps off a distant light", "[motion]") {
    // A roof that covers the view when the shutter opens, and moves past the camera to the light.
    const auto lit = [](const std::string& integrator, const std::string& beside) {
        return mean_of(
            pbrt_scene("LightSource \"distant\" \"rgb L\" [3 3 3] \"point from\" [0 0 -1] "
                       "\"point to\" [0 0 0]\nShape \"disk\"\n" +
                           beside +
                           "ActiveTransform EndTime Translate 0 0 -100 ActiveTransform All\n"
                           "Translate 0 0 -1 Shape \"disk\" \"float radius\" 2\n",
                       "Integrator \"" + integrator + "\" \"integer maxdepth\" 1"));
    };
    const double roof_alone = lit("path", "");
    CHECK(roof_alone < 0.1);
    const std::string veil =
        "AttributeBegin Translate .8 0 0 Material \"none\" Shape \"disk\" "
        "\"float radius\" .1 AttributeEnd\n";
    CHECK_THAT(lit("volpath", veil), WithinAbs(roof_alone, 0.01));
}

TEST_CASE("What moves in a scene scaled by a power of two gives the same pixels", "[motion]") {
    const TestScene scene = pbrt_scene("LightSource \"infinite\" " + turn + "Shape \"sphere\"");
    TestScene small = scene;
    static_cast<Scene&>(small) = transformed(scene, 0x1p-7);
    CHECK(image(small) == image(scene));
}

TEST_CASE("A camera that moves makes the rays of one that stands where it is", "[motion]") {
    for (const std::string type :
         {"perspective\" \"float lensradius\" 0.1 \"float focaldistance\" 3", "orthographic\"",
          "environment\""}) {
        const TestScene scene = pbrt_scene(
            "",
            "ActiveTransform EndTime Rotate 30 0 1 0 Translate 0 1 2 ActiveTransform All "
            "Camera \"" +
                type);
        const ProjectiveCamera& moving = scene.camera.projective.value();
        CAPTURE(type);
        REQUIRE((moving.motion && scene.camera.sees_motion));
        const CameraRays rays(scene.camera, {8, 8});
        for (const double part : {0.0, 0.25, 0.9}) {
            const Camera still = still_at(moving.motion->at(shutter_time(part)), scene.camera);
            const Ray expected = CameraRays(still, {8, 8}).ray({1.5, 6}, {0.3, 0.8});
            const Ray ray = rays.ray({1.5, 6}, {0.3, 0.8}, shutter_time(part));
            CHECK((ray.origin == expected.origin && ray.direction == expected.direction));
            CHECK(ray.time() == shutter_time(part));
        }
    }
}

TEST_CASE("Camera rays are of all times if something moves, else of the first", "[motion]") {
    double sum = 0;
    for (const Ray& ray : rays_of_pixel(pbrt_scene(leaving_square), 64))
        sum += ray.time() * 0x1p-24;
    CHECK(sum / 64 == Approx(0.5).epsilon(0.02));
    const TestScene still = pbrt_scene("Shape \"sphere\"");
    for (const Ray& ray : rays_of_pixel(still, 64)) CHECK(ray.time() == 0);
    TestScene timed = still;
    timed.camera.sees_motion = true;
    const std::vector<Ray> a = rays_of_pixel(still, 64), b = rays_of_pixel(timed, 64);
    for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i].direction == b[i].direction);
}

TEST_CASE("Motion within an object is left out with a warning", "[motion]") {
    const LoadResult loaded = load_scene_text("WorldBegin ObjectBegin \"o\" " + turn +
                                                  "Shape \"sphere\" ObjectEnd "
                                                  "ObjectInstance \"o\" WorldEnd",
                                              "test.pbrt");
    REQUIRE((loaded.scene && loaded.diagnostics.size() == 1));
    CHECK(loaded.diagnostics[0].kind == "motion");
}
