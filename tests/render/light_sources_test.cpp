// Light that reaches a surface is the same however it is represented, and however it is sampled.
#include <numbers>

#include "tests/catch.h"
#include "tests/render/pbrt_scene.h"
#include "tests/render/test_images.h"

using namespace etalon;
using namespace etalon::test;
using Catch::Matchers::WithinRel;

namespace {

double brightness(const std::string& world, const std::string& options = "") {
    double sum = 0;
    const std::vector<Color> pixels =
        image(pbrt_scene(world,
                         "Camera \"perspective\" \"float fov\" .01\n"
                         "Sampler \"sobol\" \"integer pixelsamples\" 256\n" +
                             options));
    for (const Color& c : pixels) sum += c.y;
    return sum / static_cast<double>(pixels.size());
}

/// Light of the same radiance from all sides, found by rays alone, and sampled.
const std::string sky = "LightSource \"infinite\"\n";
const std::string enclosure =
    "AttributeBegin ReverseOrientation AreaLightSource \"diffuse\"\n"
    "Material \"matte\" \"color Kd\" [0 0 0] Shape \"sphere\" \"float radius\" 40 AttributeEnd\n";

/// A square that faces the camera.
const std::string square =
    "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3]\n"
    "\"point P\" [-1 -1 0 -1 1 0 1 1 0 1 -1 0]\n";

const std::string plate = "Material \"matte\" \"color Kd\" [1 1 1]\n" + square;

std::string one_bounce(const std::string& integrator = "path") {
    return "Integrator \"" + integrator + "\" \"integer maxdepth\" 1";
}

}  // namespace

TEST_CASE("Light between the horizons of both normals is found by rays too", "[light]") {
    const std::string normals = "\"normal N\" [.8 .1 -1 .8 .1 -1 .8 .1 -1 .8 .1 -1] AttributeEnd";
    for (const std::string turn : {"Rotate 70 0 1 0 ", "Rotate -70 0 1 0 "}) {
        for (const std::string material :
             {"\"substrate\"", "\"metal\" \"float roughness\" .3", "\"plastic\"", "\"disney\"",
              "\"matte\"", "\"translucent\""}) {
            INFO(turn << material);
            const std::string seen =
                "AttributeBegin " + turn + "Material " + material + " " + square + normals;
            CHECK_THAT(brightness(sky + seen, one_bounce()),
                       WithinRel(brightness(enclosure + seen, one_bounce()), 2e-2));
        }
    }
}

TEST_CASE("A light that cannot be sampled is not asked for light", "[light]") {
    const std::string curve =
        "Translate 5 0 -3 AreaLightSource \"diffuse\" \"color L\" [10 10 10] Shape \"curve\"\n"
        "\"point P\" [0 0 0 0 .1 0 0 .2 0 0 .3 0] \"float width\" .001";
    for (const char* name : {"path", "directlighting", "whitted"}) {
        CHECK(brightness(plate + curve, one_bounce(name)) < 1e-4);
    }
}

TEST_CASE("Rough skin lets no light straight through", "[light]") {
    const std::string skin =
        "Material \"kdsubsurface\" \"color Kd\" [.8 .8 .8] \"color mfp\" [.01 .01 .01]\n"
        "\"float uroughness\" .2 \"float vroughness\" .2 AttributeBegin Scale 9 9 9\n" +
        square + "AttributeEnd\n";
    const std::string behind = "LightSource \"point\" \"point from\" [0 0 2] \"color I\" [9 9 9]\n";
    CHECK(brightness(behind + skin) < 1e-3);
    const std::string some = "Sampler \"sobol\" \"integer pixelsamples\" 64";
    CHECK_THAT(brightness(sky + skin, some), WithinRel(brightness(enclosure + skin, some), 3e-2));
}

TEST_CASE("Rough glass of index 1 is not seen", "[light]") {
    const std::string glass =
        "Material \"glass\" \"float uroughness\" .1 \"float vroughness\" .1 \"float index\" ";
    const std::string disney =
        "Material \"disney\" \"color color\" [1 1 1] \"float spectrans\" 1 \"float eta\" ";
    for (const std::string index : {"1 ", "1.000001 ", "1.0001 "}) {
        for (const std::string& material : {glass, disney}) {
            INFO(material << index);
            CHECK_THAT(brightness(sky + "Rotate 20 0 1 0 " + material + index + square),
                       WithinRel(1.0, 2e-2));
        }
    }
}

TEST_CASE("A sphere that shines inward through its near side lights what is outside", "[light]") {
    const std::string lamp =
        "AreaLightSource \"diffuse\" \"color L\" [5 5 5] Translate 0 .6 -1.2\n"
        "Shape \"sphere\" \"float radius\" .4 AttributeEnd\n";
    const double lit = brightness("AttributeBegin " + lamp + plate, one_bounce());
    const std::string inward = "AttributeBegin ReverseOrientation Material \"none\" " + lamp;
    CHECK_THAT(brightness(inward + plate, one_bounce("volpath")), WithinRel(lit, 1e-2));
}

TEST_CASE("The primitives of a shape are one light of the scene", "[light]") {
    const std::string lamp = "AttributeBegin AreaLightSource \"diffuse\"\n";
    const std::string dark = plate + "AttributeBegin " + square + "AttributeEnd\n";
    const TestScene scene = pbrt_scene(dark + lamp + square + square + "AttributeEnd");
    REQUIRE(scene.physical().lights.size() == 2);
    std::uint32_t first = 4;
    for (const PhysicalLight& light : scene.physical().lights) {
        const auto& area = std::get<AreaSource>(light);
        CHECK(area.first == first);
        CHECK(area.count == 2);
        first += 2;
    }
}

TEST_CASE("A small light lights as much from any distance", "[light]") {
    for (const double distance : {1e3, 1e6, 1e8}) {
        const double radiance = distance * distance / 1e-6 / std::numbers::pi;
        const std::string lamp = fmt::format(
            "AttributeBegin AreaLightSource \"diffuse\" \"color L\" [{0} {0} {0}]\n"
            "Translate 0 {1} {2} Shape \"sphere\" \"float radius\" 1e-3 AttributeEnd\n",
            radiance, .6 * distance, -.8 * distance);
        CHECK_THAT(brightness(lamp + plate, one_bounce()), WithinRel(.8 / std::numbers::pi, 1e-3));
    }
}
