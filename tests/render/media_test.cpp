// Compares paths through media with closed forms for small scenes.
#include <numbers>

#include "core/formats/load.h"
#include "core/integrators/path/lit_regions_from.h"
#include "core/medium/henyey_greenstein.h"
#include "core/scene/transformed.h"
#include "tests/each_instruction_set.h"
#include "tests/render/test_images.h"

using namespace etalon;
using namespace etalon::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// A scene of 8 x 8 pixels with a narrow camera at (0, 0, -5) that looks along z.
TestScene scene_of(const std::string& world, const std::string& options = "") {
    const std::string text =
        "LookAt 0 0 -5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" .1\n"
        "Film \"image\" \"integer xresolution\" 8 \"integer yresolution\" 8\n"
        "Sampler \"sobol\" \"integer pixelsamples\" 256\n"
        "Integrator \"volpath\" \"integer maxdepth\" 1000\n" +
        options + "\nWorldBegin\n" + world + "\nWorldEnd\n";
    LoadResult loaded = load_scene_text(text, "test.pbrt");
    REQUIRE(loaded.scene);
    INFO(report(loaded.diagnostics));
    REQUIRE(loaded.diagnostics.empty());
    TestScene scene;
    static_cast<Scene&>(scene) = std::move(*loaded.scene);
    scene.settings = loaded.settings;
    return scene;
}

Vec3 mean(const std::vector<Color>& pixels) {
    Vec3 sum(0);
    for (const Color& c : pixels) sum += Vec3(c);
    return sum / static_cast<double>(pixels.size());
}

Vec3 brightness(const std::string& world, const std::string& options = "") {
    return mean(image(scene_of(world, options)));
}

void check_equal(const Vec3& mean, const Vec3& expected, double tolerance) {
    for (int c = 0; c < 3; ++c) {
        INFO("channel " << c);
        CHECK_THAT(mean[c], WithinRel(expected[c], tolerance));
    }
}

const std::string sky = "LightSource \"infinite\" \"color L\" [1 1 1]\n";
const std::string absorbing =
    "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [.1 .5 1] \"rgb "
    "sigma_s\" "
    "[0 0 0]\n";
const std::string white =
    "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" "
    "[1 2 4] \"float g\" .5\n";
const std::string ball = "MediumInterface \"m\" \"\" Material \"none\" Shape \"sphere\"\n";

/// A grid of 4 x 4 x 4 densities in the cube [-1, 1]^3.
std::string grid(const std::string& coefficients, bool is_even) {
    std::string text =
        "MakeNamedMedium \"m\" \"string type\" \"heterogeneous\" \"integer nx\" 4 \"integer ny\" 4 "
        "\"integer nz\" 4 \"point p0\" [-1 -1 -1] \"point p1\" [1 1 1] " +
        coefficients + " \"float density\" [";
    for (int i = 0; i < 64; ++i) text += is_even ? " 1" : std::to_string(i * i % 5) + " ";
    return text + "]\n";
}

/// Fog with a spot that lights up a floor and a wall.
TestScene foggy_spot(const std::string& world) {
    return scene_of(
        "LightSource \"spot\" \"point from\" [-2 3 -2] \"point to\" [0 0 0] "
        "\"color I\" [50 40 60] \"float coneangle\" 16\n" +
            world +
            "Material \"matte\"\nShape \"trianglemesh\" \"integer indices\" [0 1 2 2 3 0] "
            "\"point P\" [-4 0 -4  4 0 -4  4 0 4  -4 0 4]\n"
            "Shape \"trianglemesh\" \"integer indices\" [0 1 2 2 3 0] "
            "\"point P\" [-4 0 4  4 0 4  4 6 4  -4 6 4]\n",
        "Identity LookAt 0 1 -7  0 1 0  0 1 0\nCamera \"perspective\" \"float fov\" 50\n"
        "Film \"image\" \"integer xresolution\" 16 \"integer yresolution\" 16\n"
        "Sampler \"sobol\" \"integer pixelsamples\" 2048\n"
        "Integrator \"volpath\" \"integer maxdepth\" 6\n"
        "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"rgb sigma_a\" "
        "[.05 .04 .03] \"rgb sigma_s\" [.1 .12 .08] \"float g\" .3\n"
        "MediumInterface \"\" \"fog\"\n");
}

const std::string white_grid = "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [1 2 3]";

}  // namespace

TEST_CASE("An absorbing medium transmits light by Beer's law", "[media]") {
    const Vec3 expected(std::exp(-0.2), std::exp(-1.0), std::exp(-2.0));
    check_equal(brightness(sky + absorbing + ball), expected, 1e-4);
    check_equal(brightness(sky + absorbing +
                           "AttributeBegin Material \"none\" Scale 1 1 .25 ReverseOrientation "
                           "MediumInterface \"\" \"m\" Shape \"sphere\" AttributeEnd"),
                {std::exp(-0.05), std::exp(-0.25), std::exp(-0.5)}, 1e-4);
}

TEST_CASE("A camera in a medium sees attenuated light", "[media]") {
    const std::string wall =
        "AreaLightSource \"diffuse\" Material \"matte\" Shape \"trianglemesh\" \"point P\" "
        "[-9 -9 0 9 -9 0 0 9 0] \"integer indices\" [0 2 1]";
    const Vec3 left(std::exp(-0.5), std::exp(-2.5), std::exp(-5.0));
    check_equal(brightness(absorbing + "MediumInterface \"\" \"m\" " + wall), left, 1e-4);
    check_equal(brightness(absorbing + "MediumInterface \"\" \"m\" " + wall,
                           "Integrator \"volpath\" \"integer maxdepth\" 0"),
                left, 1e-4);
}

TEST_CASE("A medium that absorbs nothing is not seen in an even sky", "[media]") {
    // The channels are sampled together: one is brighter by chance where another is darker.
    const std::string in_glass = "MediumInterface \"m\" \"\" Material \"glass\" Shape \"sphere\"";
    const std::string in_box =
        "MediumInterface \"m\" \"\" Material \"none\" Shape \"sphere\" \"float radius\" 1.8";
    for (const std::string& world :
         {white + ball, white + in_glass, grid(white_grid, false) + in_box}) {
        const Vec3 seen = brightness(sky + world);
        check_equal(seen, Vec3(1), 0.03);
        CHECK_THAT((seen.x + seen.y + seen.z) / 3, WithinRel(1.0, 5e-3));
    }
}

TEST_CASE("A grid of one density looks as a homogeneous medium", "[media]") {
    const std::string colors = "\"rgb sigma_a\" [.3 .2 .1] \"rgb sigma_s\" [1 .5 2] \"float g\" .3";
    const std::string even =
        "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" " + colors + "\n";
    const std::string small =
        "MediumInterface \"m\" \"\" Material \"none\" Shape \"sphere\" "
        "\"float radius\" .7\n";
    const std::string lamp = "LightSource \"point\" \"color I\" [5 5 5] \"point from\" [1 2 -2]\n";
    const std::string samples =
        "Integrator \"volpath\" Sampler \"sobol\" \"integer pixelsamples\" 2048";
    check_equal(brightness(sky + lamp + grid(colors, true) + small, samples),
                brightness(sky + lamp + even + small, samples), 0.015);
}

TEST_CASE("Single scattering in a medium follows its phase function", "[media]") {
    // Thin, so that little light is scattered twice; along the ray it is that of a distant light.
    const std::string thin =
        "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [0 0 0] "
        "\"rgb sigma_s\" [.01 .01 .01] \"float g\" .6\n";
    for (const Vec3& from : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0, 1, 0)}) {
        const std::string light = "LightSource \"distant\" \"point from\" [" +
                                  std::to_string(from.x) + " " + std::to_string(from.y) + " " +
                                  std::to_string(from.z) + "] \"point to\" [0 0 0]\n";
        const Vec3 seen = brightness(light + thin + ball,
                                     "Integrator \"volpath\" \"integer maxdepth\" 1\n"
                                     "Sampler \"sobol\" \"integer pixelsamples\" 4096");
        const double expected = 0.01 * 2 * HenyeyGreenstein(0.6F).value(from.z);
        INFO(from);
        CHECK_THAT(seen.y, WithinRel(expected, 0.03));
    }
}

TEST_CASE("Directions to the beam of a spot have their density", "[media]") {
    const TestScene scene = foggy_spot("");
    const auto intersector = find_backend(default_backend)->build(scene.geometry);
    std::vector<std::string> problems;
    const Lights lights(scene, problems);
    const LitRegions regions(scene, lights, *intersector);
    REQUIRE(!regions.empty());
    for (const Receiver& at : {Receiver{{0.5, 1, -1}}, Receiver{{-1.9, 2.8, -1.9}},
                               Receiver{{2, 0, 1}, {0, 1, 0}}, Receiver{{0, 3, 3}, {0, 0, -1}}}) {
        const LitRegionsFrom seen(regions, at);
        REQUIRE(!seen.empty());
        constexpr int count = 2000000;
        Random random(1);
        double integral = 0;
        int unknown = 0;
        Vec3 mean(0), expected(0);
        for (int i = 0; i < count; ++i) {
            const double z = 2 * random.uniform() - 1,
                         phi = 2 * std::numbers::pi * random.uniform();
            const double r = std::sqrt(1 - z * z);
            const Vec3 any(r * std::cos(phi), r * std::sin(phi), z);
            const double weight = 4 * std::numbers::pi * seen.density(any) / count;
            integral += weight;
            expected += weight * any;
            const double choice = random.uniform(), u = random.uniform(), v = random.uniform();
            const Vec3 wi = seen.sample(choice, {u, v});
            unknown += seen.density(wi) > 0 ? 0 : 1;
            mean += wi / count;
        }
        INFO(at.position);
        CHECK(unknown == 0);
        CHECK_THAT(integral, WithinAbs(1, 0.03));
        for (int c = 0; c < 3; ++c) CHECK_THAT(mean[c], WithinAbs(expected[c], 0.03));
    }
}

TEST_CASE("Each direction to the beam of a spot has a density, from afar too", "[media]") {
    const TestScene scene = foggy_spot("");
    const auto intersector = find_backend(default_backend)->build(scene.geometry);
    std::vector<std::string> problems;
    const Lights lights(scene, problems);
    const LitRegions regions(scene, lights, *intersector);
    REQUIRE(!regions.empty());
    for (const double distance : {3.0, 300.0, 3e4, 1e6}) {
        const LitRegionsFrom seen(regions, {distance * normalized(Vec3(-0.3, 0.8, -0.5))});
        Random random(1);
        int unknown = 0;
        for (int i = 0; i < 100000; ++i) {
            const double choice = random.uniform(), u = random.uniform(), v = random.uniform();
            unknown += seen.density(seen.sample(choice, {u, v})) > 0 ? 0 : 1;
        }
        INFO(distance);
        CHECK(unknown == 0);
    }
}

TEST_CASE("Directions to the beam of a spot have the same bits with each instruction set",
          "[media]") {
    const TestScene scene = foggy_spot("");
    const auto intersector = find_backend(default_backend)->build(scene.geometry);
    std::vector<std::string> problems;
    const Lights lights(scene, problems);
    const LitRegions regions(scene, lights, *intersector);
    std::vector<Vec3> expected;  // of the first target: directions, and densities of two
    for_each_target([&] {
        std::vector<Vec3> all;
        Random random(1);
        for (int i = 0; i < 1000; ++i) {
            const auto coordinate = [&] { return random.uniform(-4, 4); };
            Receiver at{{coordinate(), coordinate(), coordinate()}};
            if (i % 2 == 1) at.normal = normalized(at.position);
            const LitRegionsFrom seen(regions, at);
            if (seen.empty()) continue;
            const double choice = random.uniform(), u = random.uniform(), v = random.uniform();
            all.push_back(seen.sample(choice, {u, v}));
            all.emplace_back(seen.density(all.back()), seen.density({0, 1, 0}), 0);
        }
        if (expected.empty()) expected = all;
        CHECK(all.size() > 1000);
        CHECK(all == expected);
    });
}

TEST_CASE("A spot in fog is as bright without directions to its beam", "[media]") {
    // Only a nearly black sky differs.
    const Vec3 with = mean(image(foggy_spot("")));
    const Vec3 without =
        mean(image(foggy_spot("LightSource \"infinite\" \"color L\" [1e-9 1e-9 1e-9]\n")));
    check_equal(with, without, 0.01);
}

TEST_CASE("Directions to a spot's beam carry no more light where normals are turned", "[media]") {
    // The floor's shading normals face away from the camera.
    const auto lit = [](const std::string& other_light) {
        return brightness(
            "LightSource \"spot\" \"rgb I\" [10 10 10] \"point from\" [0 -1.5 2]\n"
            "\"point to\" [0 1.5 2] \"float coneangle\" 20 \"float conedeltaangle\" 10\n" +
                other_light +
                "Material \"matte\" \"rgb Kd\" [1 1 1] Shape \"trianglemesh\"\n"
                "\"integer indices\" [0 1 2 0 2 3] \"point P\" [-3 -3 0 3 -3 0 3 3 0 -3 3 0]\n"
                "\"normal N\" [0 .4 1 0 .4 1 0 .4 1 0 .4 1]\n",
            "Identity LookAt 0 -2 .4  0 0 0  0 0 1\n"
            "Camera \"orthographic\" \"float screenwindow\" [-.5 .5 -.2 .2]\n"
            "Sampler \"sobol\" \"integer pixelsamples\" 8192\n"
            "Integrator \"volpath\" \"integer maxdepth\" 2\n"
            "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" \"rgb sigma_a\" "
            "[.02 .02 .02] \"rgb sigma_s\" [.2 .2 .2]\n"
            "MediumInterface \"\" \"fog\"\n");
    };
    // The standard error of the second is 5 %.
    check_equal(lit(""), lit("LightSource \"infinite\" \"rgb L\" [1e-9 1e-9 1e-9]\n"), 0.3);
}

TEST_CASE("Surfaces without a material hide lights from path alone", "[media]") {
    const std::string world =
        "LightSource \"point\" \"color I\" [10 10 10] \"point from\" [0 0 -3]\n"
        "Material \"matte\" Shape \"sphere\" Material \"none\" Shape \"sphere\" \"float radius\" 2";
    const double expected = 0.5 / std::numbers::pi * 10 / 4;
    CHECK_THAT(brightness(world).y, WithinRel(expected, 1e-3));
    CHECK(brightness(world, "Integrator \"path\"").y == 0);
}

TEST_CASE("volpath is path where there are no media", "[media]") {
    const std::string world = sky + "Material \"plastic\" Shape \"sphere\"";
    CHECK(image(scene_of(world)) ==
          image(scene_of(world, "Integrator \"path\" \"integer maxdepth\" 1000")));
}

TEST_CASE("Paths in media have the same bits with every exact backend, and at another scale",
          "[media]") {
    const std::string world = sky + grid(white_grid, false) +
                              "LightSource \"point\" \"point from\" [0 3 -2]\n"
                              "AttributeBegin MediumInterface \"m\" \"\" Material \"none\" "
                              "Shape \"sphere\" \"float radius\" 1.5 AttributeEnd\n" +
                              "MakeNamedMedium \"n\" \"string type\" \"homogeneous\" \"string "
                              "preset\" \"Skin1\" MediumInterface \"n\" \"\" Material \"glass\" "
                              "Translate .5 0 0 Shape \"sphere\" \"float radius\" .5";
    TestScene scene = scene_of(world,
                               "Camera \"perspective\" \"float fov\" 40\n"
                               "Sampler \"sobol\" \"integer pixelsamples\" 4");
    scene.settings.resolution = {24, 20};
    const std::vector<Color> expected = image(scene, reference_backend);
    CHECK(mean(expected).y > 0.1);
    for (const Backend& backend : all_backends()) {
        if (backend.exact) CHECK(image(scene, backend.name) == expected);
    }
    for (const double factor : {0x1p-9, 0x1p7}) {
        CHECK(image(transformed(scene, factor)) == expected);
    }
}
