// Images of scenes whose colours are display values, written by the programs.
#include <nlohmann/json.hpp>

#include <cstring>

#include "core/color/srgb.h"
#include "core/image/io.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

using nlohmann::json;

namespace {

/// Folder with the light.exr and light.png of a scene, and display.exr and display.png with its
/// display values kept.
struct TwoPictures : Folder {
    TwoPictures() {
        write("ball.p3f", small_scene);
        render("-o light.exr -o light.png");
        render("--display-values -o display.exr -o display.png");
    }
    void render(const std::string& options) const {
        REQUIRE(etalon("render ball.p3f --spp 4 -q " + options).status == 0);
    }
    Image image(const std::string& name) const {
        const Result<Image> read = read_image(path(name));
        REQUIRE(read.error == "");
        return read.value;
    }
    json compared(const std::string& pair) const {
        REQUIRE(etalon("compare " + pair + " --json c.json").status == 0);
        return json::parse(read("c.json"));
    }
};

}  // namespace

TEST_CASE("an EXR holds the light that display values stand for, unless they are kept", "[app]") {
    const TwoPictures f;
    const Image light = f.image("light.exr"), display = f.image("display.exr");
    CHECK(light.encoding == Encoding::linear);
    CHECK(display.encoding == Encoding::display);
    double largest = 0;
    for (int y = 0; y < light.height; ++y) {
        for (int x = 0; x < light.width; ++x) {
            for (int k = 0; k < 3; ++k) {
                const double shown = srgb_encoded(light.color(x, y)[k]);
                CHECK(shown == Approx(display.color(x, y)[k]).margin(1e-6));
                largest = std::max(largest, shown);
            }
        }
    }
    CHECK(largest > 0.5);
}

TEST_CASE("a PNG has the display values, independent of an EXR of the same rendering", "[app]") {
    const TwoPictures f;
    CHECK(f.read("light.png") == f.read("display.png"));
}

TEST_CASE("compare knows light from display values", "[app]") {
    const TwoPictures f;
    CHECK(f.compared("light.exr display.exr")["max_abs"] == 0);
    CHECK(f.compared("display.exr light.exr")["max_abs"] == 0);
    CHECK(f.compared("display.exr display.png")["max_abs"] <= 1 / 255.0);
    // The curve is steepest at white: a step of a PNG is 2.3 as much light there.
    CHECK(f.compared("light.exr light.png")["max_abs"] <= 2.3 / 255);
}

TEST_CASE("what is seen of display values is what is seen of their light", "[app]") {
    const TwoPictures f;
    f.render("--seed 3 -o light3.exr");
    f.render("--seed 3 --display-values -o display3.exr --reference display.exr --stats s.json");
    const json light = f.compared("light3.exr light.exr");
    const json display = f.compared("display3.exr display.exr");
    CHECK(display["relmse"] != light["relmse"]);
    for (const char* metric : {"flip", "ssim"}) {
        CHECK(display[metric].get<double>() == Approx(light[metric].get<double>()).epsilon(1e-5));
    }
    CHECK(json::parse(f.read("s.json"))["error"] == display);
}

TEST_CASE("render --reference takes either, in the values of the image", "[app]") {
    const TwoPictures f;
    for (const char* reference : {"light.exr", "display.exr"}) {
        for (const char* values : {"", "--display-values "}) {
            INFO(reference << " " << values);
            f.render(std::string(values) + "--reference " + reference +
                     " -o again.exr --stats s.json");
            CHECK(json::parse(f.read("s.json"))["error"]["max_abs"] <= 1e-6);
            f.render(std::string(values) + "--seed 3 --reference " + reference +
                     " -o again.exr --stats s.json");
            const json error = json::parse(f.read("s.json"))["error"];
            const bool same_kind = (*values != 0) == (std::strcmp(reference, "display.exr") == 0);
            if (same_kind) CHECK(error == f.compared(std::string("again.exr ") + reference));
            CHECK(error["relmse"] > 0);
        }
    }
}

TEST_CASE("an sRGB view of the EXR is the PNG, to a step", "[app][needs_oiiotool]") {
    const TwoPictures f;
    SKIP_UNLESS(f.shell("command -v oiiotool").status == 0, "oiiotool is not installed");
    REQUIRE(f.shell("oiiotool light.exr --colorconvert linear sRGB -d uint8 -o view.png").status ==
            0);
    const Image view = f.image("view.png"), png = f.image("light.png");
    REQUIRE(view.width == png.width);
    for (int y = 0; y < png.height; ++y) {
        for (int x = 0; x < png.width; ++x) {
            for (int k = 0; k < 3; ++k) {
                CHECK(std::abs(view.color(x, y)[k] - png.color(x, y)[k]) <= 1.01 / 255);
            }
        }
    }
}

TEST_CASE("ambient occlusion is a fraction, not a display value", "[app]") {
    const Folder f;
    f.write("corner.p3f", small_scene + "pl 0 0 -1  1 0 -1  0 1 -1\n");
    REQUIRE(f.etalon("convert corner.p3f -o corner.pbrt").status == 0);
    const std::string options = " --integrator ao --spp 16 -q ";
    REQUIRE(f.etalon("render corner.p3f" + options + "-o a.exr -o a.png").status == 0);
    REQUIRE(f.etalon("render corner.pbrt" + options + "-o b.exr -o b.png").status == 0);
    for (const std::string format : {".exr", ".png"}) {
        REQUIRE(f.etalon("compare a" + format + " b" + format + " --json c.json").status == 0);
        const json compared = json::parse(f.read("c.json"));
        for (int k = 0; k < 3; ++k) {
            CHECK(compared["mean_a"][k].get<double>() ==
                  Approx(compared["mean_b"][k].get<double>()).epsilon(0.02));
        }
    }
}

TEST_CASE("a sky of light is as bright in the image as in its files", "[app]") {
    const Folder f;
    const Color light(0.18F, 0.5F, 2);
    REQUIRE(f.shell("mkdir sky").status == 0);
    for (const std::string face : {"right", "left", "top", "bottom", "front", "back"}) {
        const RenderedImage image{4, 4, {{0, 0}, {3, 3}}, std::vector<Color>(16, light), false, {}};
        REQUIRE(write_image(f.path("sky/" + face + ".exr"), image) == "");
    }
    f.write("sky.p3f",
            "env sky\ncamera eye 0 0 5 at 0 0 0 up 0 1 0 angle 90 hither 0 "
            "resolution 8 8 aperture 0 focal 1\n");
    for (const std::string integrator : {"whitted", "path"}) {
        CAPTURE(integrator);
        REQUIRE(f.etalon("render sky.p3f -q --spp 1 -o s.exr --integrator " + integrator).status ==
                0);
        const Image image = read_image(f.path("s.exr")).value;
        for (int k = 0; k < 3; ++k) CHECK(image.color(3, 5)[k] == Approx(light[k]).epsilon(1e-6));
    }
}
