#include <cmath>

#include "core/formats/pbrt/build/scattering_presets.h"
#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

const std::string make_a = "MakeNamedMedium \"a\" \"string type\" \"homogeneous\" ";
const std::string make_b = "MakeNamedMedium \"b\" \"string type\" \"homogeneous\" ";

}  // namespace

TEST_CASE("a medium interface has a name for the inside and one for the outside") {
    const Frame frame =
        good_world(make_a + make_b +
                   "MediumInterface \"b\" \"a\" Shape \"sphere\" "
                   "MediumInterface \"b\" Shape \"sphere\" MediumInterface \"\" \"a\" "
                   "Shape \"sphere\" LightSource \"point\"");
    CHECK(frame.shapes.at(0).media == MediumInterface{1, 0});
    CHECK(frame.shapes.at(1).media == MediumInterface{1, 1});
    CHECK(frame.shapes.at(2).media == MediumInterface{none, 0});
    CHECK(frame.lights.at(0).medium == 0);
    CHECK(frame.has_media);
}

TEST_CASE("a medium may be defined after the interface that names it") {
    const Frame frame = good_world("MediumInterface \"a\" \"\" " + make_a + "Shape \"sphere\"");
    CHECK(frame.shapes.at(0).media == MediumInterface{0, none});
}

TEST_CASE("an undefined medium is an error at each shape and light that uses it") {
    const ParsedFile file = parse_world(
        "AttributeBegin MediumInterface \"a\" \"\"\nShape \"sphere\"\n"
        "LightSource \"point\" AttributeEnd");
    CHECK(messages(file) == Messages{"a.pbrt:2:1: error: no medium 'a' is defined",
                                     "a.pbrt:3:1: error: no medium 'a' is defined"});
    CHECK(file.frames.at(0).shapes.at(0).media == MediumInterface{});
}

TEST_CASE("the camera's medium is the one that is outside at WorldEnd") {
    const Frame frame = good_frame("MediumInterface \"\" \"a\" Camera \"perspective\" WorldBegin " +
                                   make_a + make_b + "MediumInterface \"a\" \"b\" WorldEnd");
    CHECK(frame.camera_medium == 1);
    const Frame options = good_frame(make_a +
                                     "MediumInterface \"\" \"a\" Camera \"perspective\" "
                                     "WorldBegin Shape \"sphere\" WorldEnd");
    CHECK(options.camera_medium == 0);
    CHECK(options.shapes.at(0).media == MediumInterface{none, 0});
}

TEST_CASE("an undefined medium of the camera is an error at the camera") {
    const ParsedFile file =
        parse_text("\nCamera \"perspective\" MediumInterface \"\" \"a\" WorldBegin WorldEnd");
    CHECK(messages(file) == Messages{"a.pbrt:2:1: error: no medium 'a' is defined"});
    CHECK(file.frames.at(0).camera_medium == none);
}

TEST_CASE("a medium is known everywhere and silently defined again") {
    const Frame frame = good_world("AttributeBegin " + make_a +
                                   "AttributeEnd MediumInterface \"a\" Shape \"sphere\" " + make_a +
                                   "Shape \"sphere\"");
    CHECK(frame.shapes.at(0).media == MediumInterface{0, 0});
    CHECK(frame.shapes.at(1).media == MediumInterface{1, 1});
    CHECK(frame.media.size() == 2);
}

TEST_CASE("a medium interface lasts to the end of its block") {
    const Frame frame = good_world(make_a +
                                   "AttributeBegin MediumInterface \"a\" AttributeEnd "
                                   "Shape \"sphere\"");
    CHECK(frame.shapes.at(0).media == MediumInterface{});
    CHECK(frame.has_media);
}

TEST_CASE("a medium has its parameters and the transformation of its place") {
    const Frame frame = good_world(
        "Translate 1 0 0 MakeNamedMedium \"a\" \"string type\" \"heterogeneous\" \"integer nx\" 2 "
        "\"integer nz\" 3 \"float density\" [1 2 3 4 5 6] \"rgb sigma_a\" [1 2 3] \"point p1\" [4 "
        "5 6]");
    const Medium& medium = frame.media.at(0);
    CHECK(medium.name == "a");
    CHECK(medium.plugin.parameters.numbers("density").size() == 6);
    CHECK(medium.plugin.parameters.color("sigma_a") == Color(1, 2, 3));
    CHECK(medium.plugin.parameters.vector("p1") == Vec3f(4, 5, 6));
    CHECK(image(frame.transforms[medium.to_world], {0, 0, 0}) == Vec3(1, 0, 0));
}

TEST_CASE("a medium that is not whole is not made") {
    const std::string grid = "MakeNamedMedium \"a\" \"string type\" \"heterogeneous\" ";
    world_with("MakeNamedMedium \"a\"",
               "a.pbrt:1:12: error: 'MakeNamedMedium' has no \"string type\"");
    world_with("MakeNamedMedium \"a\" \"string type\" \"fog\"",
               "a.pbrt:1:12: warning: unknown medium 'fog'; it is not defined; there are: "
               "homogeneous heterogeneous");
    world_with(grid,
               "a.pbrt:1:12: error: the medium 'heterogeneous' is left out: 'float density' is "
               "missing");
    world_with(grid + "\"integer nx\" 2 \"float density\" 1",
               "a.pbrt:1:12: error: the medium 'heterogeneous' is left out: it has 1 densities for "
               "2 x 1 x 1");
    world_with(grid +
                   "\"integer nx\" [2000000000] \"integer ny\" [2000000000] \"integer nz\" "
                   "[2000000000] \"float density\" 1",
               "a.pbrt:1:12: error: the medium 'heterogeneous' is left out: it has 1 densities for "
               "2000000000 x "
               "2000000000 x 2000000000");
    CHECK(parse_world(grid + "\"integer nx\" -1 \"integer ny\" -1 \"float density\" 1")
              .frames.at(0)
              .media.empty());
}

TEST_CASE("the measured coefficients are those of pbrt-v3's table") {
    // Sums of the logarithms of all numbers but 0, each times its place, of its core/medium.cpp.
    double absorption = 0, scattering = 0;
    int place = 0, zeros = 0;
    const auto add = [&](float value, double& sum) {
        if (value == 0) {
            ++zeros;
        } else {
            sum += place * std::log(static_cast<double>(value));
        }
    };
    for (const std::string_view name : scattering_preset_names()) {
        const ScatteringPreset& preset = *find_scattering_preset(name);
        for (std::size_t k = 0; k < 3; ++k) {
            ++place;
            add(preset.absorption[k], absorption);
            add(preset.scattering[k], scattering);
        }
    }
    CHECK(place == 3 * 47);
    CHECK(zeros == 10);
    CHECK(absorption == Approx(-26436.35294).margin(1e-4).epsilon(0));
    CHECK(scattering == Approx(-48023.80398).margin(1e-4).epsilon(0));
}
