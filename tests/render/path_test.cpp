// Compares the path tracer with closed forms for small scenes.
#include "core/scene/transformed.h"
#include "tests/catch.h"
#include "tests/render/pbrt_scene.h"
#include "tests/render/test_images.h"

using namespace etalon;
using namespace etalon::test;
using Catch::Matchers::WithinRel;

namespace {

/// Mean of the green values of an image.
double mean(const std::vector<Color>& pixels) {
    double sum = 0;
    for (const Color& c : pixels) sum += c.y;
    return sum / static_cast<double>(pixels.size());
}

double brightness(const std::string& world, const std::string& options = "") {
    return mean(image(pbrt_scene(world, options)));
}

const std::string sky = "LightSource \"infinite\" \"color L\" [1 1 1]\n";
const std::string deep = "Integrator \"path\" \"integer maxdepth\" 100";

/// A scene with all kinds of materials and lights.
const std::string room =
    "LightSource \"point\" \"color I\" [8 9 7] \"point from\" [-2 3 -3]\n"
    "LightSource \"distant\" \"point from\" [3 2 -1] \"point to\" [0 0 0] \"color L\" [.5 .4 .3]\n"
    "LightSource \"infinite\" \"color L\" [.2 .3 .4]\n"
    "AttributeBegin AreaLightSource \"diffuse\" \"color L\" [9 9 8] Translate 0 3 0\n"
    "Rotate 90 1 0 0 Shape \"disk\" \"float radius\" .5 AttributeEnd\n"
    "Texture \"checks\" \"color\" \"checkerboard\" \"float uscale\" 4 \"float vscale\" 4\n"
    "Material \"matte\" \"texture Kd\" \"checks\"\n"
    "Shape \"trianglemesh\" \"point P\" [-4 -1 -4 4 -1 -4 4 -1 4 -4 -1 4]\n"
    "\"integer indices\" [0 1 2 0 2 3] \"float uv\" [0 0 1 0 1 1 0 1]\n"
    "Material \"glass\" AttributeBegin Translate -1 0 0 Shape \"sphere\" \"float radius\" .7\n"
    "AttributeEnd Material \"metal\" \"float roughness\" .1\n"
    "AttributeBegin Translate 1 0 0 Shape \"sphere\" \"float radius\" .8 AttributeEnd\n"
    "Material \"plastic\" AttributeBegin Translate 0 -.5 -1 Shape \"sphere\" \"float radius\" .4\n"
    "AttributeEnd\n";

TestScene lit_room() {
    TestScene scene = pbrt_scene(room,
                                 "Camera \"perspective\" \"float fov\" 50\n"
                                 "Sampler \"sobol\" \"integer pixelsamples\" 4");
    scene.settings.resolution = {40, 30};
    return scene;
}

}  // namespace

TEST_CASE("A ball in a box of many lights reflects its albedo", "[path]") {
    // Six faces of 10 x 10 squares: too many lights to evaluate all at each point.
    std::string points, indices;
    for (int i = 0; i < 121; ++i) {
        points += std::to_string(i % 11 * 1.2 - 6) + " " + std::to_string(i / 11 * 1.2 - 6) + " 6 ";
    }
    for (int i = 0; i < 100; ++i) {
        const int a = i / 10 * 11 + i % 10;
        for (const int corner : {a, a + 1, a + 12, a, a + 12, a + 11}) {
            indices += std::to_string(corner) + " ";
        }
    }
    std::string box =
        "AttributeBegin Material \"matte\" \"color Kd\" [0 0 0]\n"
        "AreaLightSource \"diffuse\" \"bool twosided\" \"true\"\n";
    for (const char* turn :
         {"0 1 0 0", "90 1 0 0", "180 1 0 0", "270 1 0 0", "90 0 1 0", "270 0 1 0"}) {
        box += "TransformBegin Rotate " + std::string(turn) +
               " Shape \"trianglemesh\" \"point P\" [" + points + "] \"integer indices\" [" +
               indices + "] TransformEnd\n";
    }
    box += "AttributeEnd Material \"matte\" \"color Kd\" [.5 .5 .5] Shape \"sphere\"";
    CHECK_THAT(brightness(box), WithinRel(0.5, 0.005));
}

TEST_CASE("A ball in an even sky reflects its albedo, without noise", "[path]") {
    const std::string ball = "Material \"matte\" \"color Kd\" [.25 .5 .75] Shape \"sphere\"";
    for (const Color& c : image(pbrt_scene(sky + ball))) {
        CHECK_THAT(c.x, WithinRel(0.25F, 1e-4F));
        CHECK_THAT(c.y, WithinRel(0.5F, 1e-4F));
        CHECK_THAT(c.z, WithinRel(0.75F, 1e-4F));
    }
}

TEST_CASE("In a glowing ball light adds up to a geometric series", "[path]") {
    const std::string ball =
        "AreaLightSource \"diffuse\" \"color L\" [1 1 1] Material \"matte\" \"color Kd\" [.5 .5 "
        ".5]\n"
        "ReverseOrientation Shape \"sphere\" \"float radius\" 20";
    CHECK_THAT(brightness(ball, deep), WithinRel(2.0, 5e-3));
    for (const int bounces : {0, 1, 2}) {  // 1, 1.5, 1.75
        const std::string options =
            "Integrator \"path\" \"integer maxdepth\" " + std::to_string(bounces);
        CHECK_THAT(brightness(ball, options), WithinRel(2 - std::pow(0.5, bounces), 5e-3));
    }
}

TEST_CASE("A roulette threshold of 0 and less ends no path that carries light", "[path]") {
    const auto threshold = [](const char* number) {
        return std::string("Integrator \"path\" \"integer maxdepth\" 20 \"float rrthreshold\" ") +
               number;
    };
    const std::string glowing =
        "AreaLightSource \"diffuse\" \"color L\" [1 1 1]\n"
        "Material \"matte\" \"color Kd\" [.5 .5 .5]\n"
        "ReverseOrientation Shape \"sphere\" \"float radius\" 20\n";
    // Nothing is left of light that has met the red and the green half of a ball.
    const std::string red_and_green =
        "LightSource \"point\" \"color I\" [9 9 9] \"point from\" [0 0 -4]\n"
        "ReverseOrientation Rotate 90 1 0 0\n"
        "Material \"matte\" \"color Kd\" [.9 0 0] Shape \"sphere\" \"float radius\" 6 "
        "\"float zmin\" 0\n"
        "Material \"matte\" \"color Kd\" [0 .9 0] Shape \"sphere\" \"float radius\" 6 "
        "\"float zmax\" 0\n";
    const double expected = brightness(red_and_green, threshold("1"));
    for (const char* number : {"0", "-1"}) {
        INFO(number);
        CHECK_THAT(brightness(glowing, threshold(number)), WithinRel(2.0, 5e-3));
        CHECK_THAT(brightness(red_and_green, threshold(number)), WithinRel(expected, 0.03));
    }
}

TEST_CASE("A point light gives intensity times cosine over the square of the distance", "[path]") {
    const std::string plane =
        "LightSource \"point\" \"color I\" [10 10 10] \"point from\" [0 3 -4]\n"
        "Material \"matte\" \"color Kd\" [.5 .5 .5]\n"
        "Shape \"trianglemesh\" \"point P\" [-9 -9 0 9 -9 0 9 9 0 -9 9 0]\n"
        "\"integer indices\" [0 1 2 0 2 3]";
    TestScene scene = pbrt_scene(plane, "Camera \"perspective\" \"float fov\" .01");
    const double expected = 0.5 / std::numbers::pi * 10 * (4.0 / 5) / 25;
    CHECK_THAT(mean(image(scene)), WithinRel(expected, 1e-4));
}

TEST_CASE("The grain of a ball turns with it", "[path]") {
    // Half way between the light and the camera is 30 degrees along x from the normal.
    const auto seen = [](const std::string& turn) {
        return brightness("LightSource \"distant\" \"point from\" [1.7320508 0 -1]\n" + turn +
                          "\nMaterial \"metal\" \"float uroughness\" 0.5 "
                          "\"float vroughness\" 0.01 \"bool remaproughness\" \"false\"\n"
                          "Shape \"sphere\"");
    };
    const double u_along_x = seen("Rotate 90 1 0 0"), u_along_y = seen("Rotate 90 0 1 0");
    CHECK(u_along_x > 100 * u_along_y);
    CHECK(u_along_x > 0.01);
}

TEST_CASE("Glass and mirrors that lose nothing are not seen in an even sky", "[path]") {
    for (const char* material : {"Material \"glass\"", "Material \"mirror\" \"color Kr\" [1 1 1]",
                                 "Material \"glass\" \"float uroughness\" 0 \"float eta\" 2.4"}) {
        INFO(material);
        CHECK_THAT(brightness(sky + material + " Shape \"sphere\"", deep), WithinRel(1.0, 2e-3));
    }
}

TEST_CASE("Direct lighting is a path of one bounce", "[path]") {
    const std::string world =
        "AttributeBegin AreaLightSource \"diffuse\" \"color L\" [5 5 5] \"integer nsamples\" 4\n"
        "Translate 0 2 -2 Shape \"sphere\" \"float radius\" .5 AttributeEnd\n"
        "LightSource \"point\" \"color I\" [3 3 3] \"point from\" [3 0 -3] Shape \"sphere\"";
    const double expected = brightness(world,
                                       "Sampler \"sobol\" \"integer pixelsamples\" 1024\n"
                                       "Integrator \"path\" \"integer maxdepth\" 1");
    for (const char* name : {"directlighting", "whitted"}) {
        CHECK_THAT(brightness(world, fmt::format("Integrator \"{}\"", name)),
                   WithinRel(expected, 5e-3));
    }
    CHECK_THAT(brightness(world, "Integrator \"directlighting\" \"string strategy\" \"one\""),
               WithinRel(expected, 1e-2));
}

TEST_CASE("A surface without material, and one cut out, are passed by rays", "[path]") {
    const std::string plane =
        "LightSource \"point\" \"color I\" [10 10 10] \"point from\" [0 0 -4]\n"
        "Material \"matte\" Shape \"trianglemesh\" \"point P\" [-9 -9 0 9 -9 0 9 9 0 -9 9 0]\n"
        "\"integer indices\" [0 1 2 0 2 3]\n";
    const std::string veil =
        "Shape \"trianglemesh\" \"point P\" [-9 -9 -2 9 -9 -2 9 9 -2 -9 9 -2]\n"
        "\"integer indices\" [0 1 2 0 2 3]\n";
    const double open = brightness(plane);
    CHECK(open > 0.05);
    CHECK_THAT(brightness(plane + veil + "\"float alpha\" 0"), WithinRel(open, 1e-6));
    // Surfaces with the null material hide lights from what is lit, as in pbrt-v3's path tracer.
    CHECK(brightness(plane + "Material \"\" " + veil) == 0);
    const std::string ball = sky + "Shape \"sphere\"", in_media = "Integrator \"volpath\"";
    CHECK(brightness(ball + "Material \"\" Shape \"sphere\" \"float radius\" 2") == 0);
    CHECK_THAT(brightness(ball + " Material \"\" " + veil, in_media),
               WithinRel(brightness(ball), 1e-6));
    const double shadowless = brightness(plane + veil + "\"float shadowalpha\" 0");
    CHECK(shadowless > 0);  // the veil itself, lit
}

TEST_CASE("What lies in the same place as a surface full of holes is seen through them", "[path]") {
    const std::string light =
        "LightSource \"point\" \"color I\" [10 10 10] \"point from\" [0 0 -4]\n";
    const std::string square =
        "Shape \"trianglemesh\" \"point P\" [-9 -9 0 9 -9 0 9 9 0 -9 9 0]\n"
        "\"integer indices\" [0 1 2 0 2 3]\n";
    const std::string holes = square + "\"float alpha\" 0\n",
                      black = "Material \"matte\" \"color Kd\" [0 0 0]\n";
    const double open = brightness(light + square);
    CHECK_THAT(brightness(light + holes + square), WithinRel(open, 1e-6));
    CHECK_THAT(brightness(light + square + holes), WithinRel(open, 1e-6));
    CHECK(brightness(light + holes + black + square + square) == 0);
    CHECK_THAT(brightness(light + holes + square + black + square), WithinRel(open, 1e-6));
}

TEST_CASE("Paths have the same bits with every exact backend", "[path]") {
    const TestScene scene = lit_room();
    const std::vector<Color> expected = image(scene, reference_backend);
    CHECK(mean(expected) > 0.1);
    for (const Backend& backend : all_backends()) {
        if (backend.exact) CHECK(image(scene, backend.name) == expected);
    }
}

TEST_CASE("A scene of paths has the same bits at another scale", "[path]") {
    const TestScene scene = lit_room();
    for (const double factor : {0x1p-9, 0x1p7}) {
        CHECK(image(transformed(scene, factor)) == image(scene));
    }
}

TEST_CASE("An adaptive image of paths comes to the same mean", "[path]") {
    TestScene scene = lit_room();
    scene.settings.samples_per_pixel = 64;
    const double expected = mean(image(scene));
    scene.settings.target_error = 2e-3;
    CHECK_THAT(mean(image(scene)), WithinRel(expected, 2e-2));
}
