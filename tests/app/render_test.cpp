// Images of etalon render, and the options that change them.
#include <OpenEXR/ImfStandardAttributes.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/image/io.h"
#include "tests/app/image_pixels.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/exr_channels.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

/// Renders ball.p3f with four samples and these options. Returns the pixels.
auto rendered(const Folder& f, const std::string& options) {
    REQUIRE(f.etalon("render ball.p3f --spp 4 -q -o a.exr " + options).status == 0);
    return pixels(f.path("a.exr"));
}

}  // namespace

TEST_CASE("render writes SCENE's name with .exr beside the caller by default", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto r = f.etalon("render ball.p3f -q");
    CHECK(r.status == 0);
    CHECK(r.err == "");
    CHECK(pixels(f.path("ball.exr")).size() == 32 * 24 * 3);
}

TEST_CASE("render gives identical pixels with every exact backend and thread count", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    REQUIRE(f.etalon("render ball.p3f --spp 3 -b none -t 1 -o a.exr").status == 0);
    for (const std::string backend : {"grid", "bvh", "embree", "embree-user"}) {
        REQUIRE(f.etalon("render ball.p3f --spp 3 -o b.exr -t 2 -b " + backend).status == 0);
        CHECK(pixels(f.path("a.exr")) == pixels(f.path("b.exr")));
    }
    REQUIRE(f.etalon("render ball.p3f --spp 3 -o b.exr -b embree-builtin").status == 0);
}

TEST_CASE("render --integrator path sees indirect light also if the scene asks for direct light",
          "[app]") {
    const Folder f;
    const std::string world =
        "Sampler \"sobol\" \"integer pixelsamples\" 4 Film \"image\" \"integer xresolution\" 8 "
        "\"integer yresolution\" 8 LookAt 0 2 4 0 0 0 0 1 0 "
        "Camera \"perspective\" \"float fov\" 30 WorldBegin LightSource \"infinite\" "
        "Shape \"sphere\" Translate 0 0 -1 Shape \"disk\" \"float radius\" 5 WorldEnd\n";
    f.write("path.pbrt", world);
    f.write("direct.pbrt", "Integrator \"directlighting\"\n" + world);
    REQUIRE(f.etalon("render path.pbrt -o path.exr").status == 0);
    REQUIRE(f.etalon("render direct.pbrt -o direct.exr").status == 0);
    REQUIRE(f.etalon("render direct.pbrt --integrator path -o both.exr").status == 0);
    CHECK(pixels(f.path("path.exr")) != pixels(f.path("direct.exr")));
    CHECK(pixels(f.path("path.exr")) == pixels(f.path("both.exr")));
}

TEST_CASE("render --spd shoots a ray through each pixel corner", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto r = f.etalon("render ball.p3f --spd -q -o a.exr --stats s.json");
    CHECK(r.status == 0);
    CHECK(pixels(f.path("a.exr")).size() == 32 * 24 * 3);
    CHECK(json::parse(f.read("s.json"))["rays"]["camera"] == 33 * 25);
    CHECK(f.etalon("render ball.p3f --spd --spp 2").status == 2);
}

TEST_CASE("render takes size, crop, depth, seed and several outputs", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto r = f.etalon(
        "render ball.p3f --resolution 64x48 --crop 8,8,24,20 --max-depth 2 "
        "--seed 7 --spp 2 --exposure 1 -o a.exr -o a.png --stats s.json");
    CHECK(r.status == 0);
    CHECK(pixels(f.path("a.exr")).size() == 16 * 12 * 3);
    CHECK(f.has("a.png"));
    const json s = json::parse(f.read("s.json"));
    CHECK(s["format"] == "p3f");
    CHECK(s["backend"] == "bvh");
    CHECK(s["integrator"] == "whitted");
    CHECK(s["image"] == json{{"width", 64}, {"height", 48}, {"spp", 2}, {"seed", 7}});
    CHECK(s["primitives"] == json{{"sphere", 1}, {"plane", 1}});
    CHECK(s["rays"]["camera"] == 16 * 12 * 2);
    for (const char* key : {"parse", "build", "render", "write", "total"}) {
        CHECK(s["seconds"].contains(key));
    }
    CHECK(s["memory_bytes"]["peak_rss"].get<double>() > 0);
}

TEST_CASE("--exposure brightens the PNG by stops, and leaves the EXR as it is", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    // The background in the corner, 0.2 0.3 0.4 as sRGB, times 1, 2 and 1/2 as light.
    const std::pair<std::string, std::array<int, 3>> stops[] = {{"", {{51, 76, 102}}},
                                                                {" --exposure 1", {{73, 107, 141}}},
                                                                {" --exposure -1", {{34, 54, 73}}}};
    REQUIRE(f.etalon("render ball.p3f -q -o plain.exr").status == 0);
    for (const auto& [option, corner] : stops) {
        CAPTURE(option);
        REQUIRE(f.etalon("render ball.p3f -q -o a.png -o a.exr" + option).status == 0);
        const auto image = etalon::read_image(f.path("a.png"));
        REQUIRE(image.error == "");
        const etalon::Color color = image.value.color(0, 0);
        for (int k = 0; k < 3; ++k) CHECK(255 * color[k] == Approx(corner[k]));
        CHECK(pixels(f.path("a.exr")) == pixels(f.path("plain.exr")));
    }
}

TEST_CASE("--max-depth is the number of surfaces that a path meets", "[app]") {
    const Folder f;
    // Two mirrors that face each other, and the eye between them: no path leaves.
    f.write("mirrors.p3f",
            "accel bvh\nspp 0\nbclr 0 0 0\ncamera\neye 0 0 0\nat 0 0 -1\nup 0 1 0\nangle 45\n"
            "hither 0.01\nresolution 4 4\naperture 0\nfocal 1\nmat 0 0 0 0 1 1 1 1 10 0 1\n"
            "pl -1 -1 -1 1 -1 -1 0 1 -1\npl -1 -1 1 0 1 1 1 -1 1\n");
    const std::pair<std::string, int> depths[] = {
        {"", 5}, {" --max-depth 1", 1}, {" --max-depth 2", 2}, {" --max-depth 9", 9}};
    for (const auto& [option, depth] : depths) {
        CAPTURE(option);
        REQUIRE(f.etalon("render mirrors.p3f -q -o a.exr --stats s.json" + option).status == 0);
        const json rays = json::parse(f.read("s.json"))["rays"];
        CHECK(rays["camera_hits"] == 16);
        CHECK(rays["reflected"] == 16 * (depth - 1));
        CHECK(rays["secondary_hits"] == 16 * (depth - 1));
    }
}

TEST_CASE("--sampler chooses the sampler; the default is Sobol's", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto render = [&](const std::string& options) { return rendered(f, options); };
    const auto plain = render("");
    CHECK(render("--sampler sobol") == plain);
    CHECK(render("--sampler random") != plain);
}

TEST_CASE("an EXR holds the matrices of its camera, for row vectors", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);  // eye 0 1 5, at 0 0 0, 45 degrees high, 4 : 3
    REQUIRE(f.etalon("render ball.p3f -q -o a.exr").status == 0);
    const Imf::InputFile file(f.path("a.exr").c_str());
    REQUIRE(Imf::hasWorldToCamera(file.header()));
    REQUIRE(Imf::hasWorldToNDC(file.header()));
    const Imath::M44f to_camera = Imf::worldToCamera(file.header()),
                      to_ndc = Imf::worldToNDC(file.header());
    const auto check = [](const Imath::M44f& matrix, const Imath::V3f& point,
                          const Imath::V3f& expected) {
        Imath::V3f seen;
        matrix.multVecMatrix(point, seen);
        for (int k = 0; k < 3; ++k) CHECK(seen[k] == Approx(expected[k]).margin(1e-5));
    };
    const float distance = std::sqrt(26.0F), from_above = 4.9029034F;  // 25 / sqrt(26)
    check(to_camera, {0, 1, 5}, {0, 0, 0});
    check(to_camera, {0, 0, 0}, {0, 0, -distance});
    check(to_camera, {1, 0, 0}, {1, 0, -distance});
    check(to_camera, {0, 1, 0}, {0, 5 / distance, -from_above});
    // 1 / tan(22.5 degrees) is 1 + sqrt(2).
    check(to_ndc, {0, 0, 0}, {0, 0, 1});
    check(to_ndc, {1, 0, 0}, {2.4142136F * 0.75F / distance, 0, 1});
    check(to_ndc, {0, 1, 0}, {0, 2.4142136F * 0.2F, 1});
}

TEST_CASE("--filter sets the reconstruction filter; the default is a box of half a pixel",
          "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto render = [&](const std::string& options) { return rendered(f, options); };
    const auto plain = render("");
    CHECK(render("--filter box") == plain);
    CHECK(render("--filter box:0.5") == plain);
    const auto gaussian = render("--filter gaussian");
    CHECK(gaussian != plain);
    CHECK(gaussian.size() == plain.size());
    CHECK(render("--filter gaussian:2") == gaussian);
    CHECK(render("--filter gaussian:1.5") != gaussian);
    for (const char* wrong : {"gauss", "box:", "box:0", "box:-1", "box:1x", "box:65", "sinc:nan"}) {
        INFO(wrong);
        const auto r = f.etalon(std::string("render ball.p3f --filter ") + wrong);
        CHECK(r.status == 2);
        CHECK_THAT(r.err, ContainsSubstring(std::string(wrong) + ": expected"));
    }
    CHECK_THAT(f.etalon("render ball.p3f --filter gausian").err,
               ContainsSubstring("did you mean 'gaussian'?"));
    CHECK(f.etalon("render ball.p3f --spd --filter gaussian").status == 2);
}

TEST_CASE("a seed has 64 bits, all of which count", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto render = [&](const std::string& seed) {
        REQUIRE(
            f.etalon("render ball.p3f --spp 1 -q -o a.exr --stats s.json --seed " + seed).status ==
            0);
        CHECK(json::parse(f.read("s.json"))["image"]["seed"].dump() == seed);
        return pixels(f.path("a.exr"));
    };
    const auto first = render("0");
    CHECK(first != render("4294967296"));
    CHECK(render("4294967296") != render("8589934592"));
    CHECK(render("18446744073709551615") != render("4294967295"));
    CHECK(f.etalon("render ball.p3f --seed 18446744073709551616").status == 2);
    CHECK(f.etalon("render ball.p3f --seed -1").status == 2);
}

TEST_CASE("--resolution keeps the part of the image that a scene crops", "[app]") {
    const Folder f;
    f.write("crop.pbrt",
            "Film \"image\" \"integer xresolution\" 1000 \"integer yresolution\" 800 \"float "
            "cropwindow\" [.3 .7 .5 .75]\nWorldBegin WorldEnd");
    REQUIRE(f.etalon("render crop.pbrt --spp 1 -q -o whole.exr").status == 0);
    REQUIRE(f.etalon("render crop.pbrt --spp 1 -q -o small.exr --resolution 50x40").status == 0);
    REQUIRE(f.etalon("render crop.pbrt --spp 1 -q -o tiny.exr --resolution 1x1").status == 0);
    const auto whole = etalon::read_image(f.path("whole.exr")).value;
    CHECK(whole.width == 400);
    CHECK(whole.height == 200);
    const auto small = etalon::read_image(f.path("small.exr")).value;
    CHECK(small.width == 20);
    CHECK(small.height == 10);
    CHECK(small.origin == Imath::V2i(15, 20));
    CHECK(small.frame == Imath::Box2i({0, 0}, {49, 39}));
    CHECK(etalon::read_image(f.path("tiny.exr")).value.width == 1);
}

TEST_CASE("an image that no light reaches through the lens is black, not missing", "[app]") {
    const Folder f;
    f.write("lens.dat", "35 3 1.6 20\n-35 5 1 20\n0 30 0 15\n");
    f.write("lens.pbrt",
            "Camera \"realistic\" \"string lensfile\" \"lens.dat\" \"float aperturediameter\" 4 "
            "\"float focusdistance\" 5\n"
            "Film \"image\" \"integer xresolution\" 64 \"integer yresolution\" 48 \"float "
            "diagonal\" 200\n"
            "WorldBegin LightSource \"infinite\" Shape \"sphere\" \"float radius\" 1000 WorldEnd");
    for (const std::string options : {"--aov albedo,N ", "--part 1/1 "}) {
        const auto r = f.etalon("render lens.pbrt --spp 2 -q --crop 0,0,4,4 " + options +
                                "-o corner.exr --stats corner.json");
        CAPTURE(options, r.err);
        CHECK(r.status == 0);
        CHECK(pixels(f.path("corner.exr")) == std::vector<float>(3 * 4 * 4, 0));
        CHECK(json::parse(f.read("corner.json"))["rays"]["camera"] == 0);
        if (options.starts_with("--part")) continue;
        CHECK(channel<float>(f.path("corner.exr"), "albedo.G") == std::vector<float>(4 * 4, 0));
        CHECK(channel<float>(f.path("corner.exr"), "N.Z") == std::vector<float>(4 * 4, 0));
    }
    CHECK(f.etalon("merge corner.exr -o merged.exr").status == 0);
}

TEST_CASE("render takes any integrator by name, auto is the scene's own", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto render = [&](const std::string& options, const std::string& name) {
        REQUIRE(f.etalon("render ball.p3f --spp 4 -q -o " + name + ".exr --stats " + name +
                         ".json " + options)
                    .status == 0);
        return json::parse(f.read(name + ".json"));
    };
    CHECK(render("", "none")["integrator"] == "whitted");
    CHECK(render("--integrator auto", "auto")["integrator"] == "whitted");
    CHECK(render("--integrator whitted", "whitted")["integrator"] == "whitted");
    const json ao = render("--integrator ao", "ao");
    CHECK(ao["integrator"] == "ao");
    CHECK(ao["rays"]["shadow"] == ao["rays"]["camera_hits"]);
    CHECK(ao["rays"]["reflected"] == 0);
    CHECK(pixels(f.path("auto.exr")) == pixels(f.path("none.exr")));
    CHECK(pixels(f.path("whitted.exr")) == pixels(f.path("none.exr")));
    CHECK(pixels(f.path("ao.exr")) != pixels(f.path("none.exr")));
    const json near = render("--integrator ao --max-distance 0.01", "near");
    CHECK(near["rays"]["shadow_blocked"] < ao["rays"]["shadow_blocked"]);
}

TEST_CASE("an unknown integrator, or an option that one would ignore, is an error with a list",
          "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const auto unknown = f.etalon("render ball.p3f --integrator bdpt");
    CHECK(unknown.status == 2);
    CHECK_THAT(unknown.err + unknown.out, ContainsSubstring("one of auto, whitted, path,"));
    CHECK_THAT(unknown.err + unknown.out, ContainsSubstring("volpath, ao"));
    f.write("ball.pbrt", "WorldBegin Shape \"sphere\" WorldEnd");
    const auto other = f.etalon("render ball.pbrt --integrator whitted");
    CHECK(other.status == 2);
    CHECK_THAT(other.err, ContainsSubstring("cannot render a pbrt scene; expected"));
    CHECK_THAT(other.err, ContainsSubstring("path or volpath or ao"));
    const std::pair<std::string, std::string> ignored[] = {
        {"--max-distance 2", "--integrator ao"},
        {"--integrator whitted --max-distance 2", "--integrator ao"},
        {"--integrator ao --max-depth 2", "--integrator whitted"},
        {"--integrator ao --spd", "--integrator whitted"}};
    for (const auto& [options, expected] : ignored) {
        INFO(options);
        const auto r = f.etalon("render ball.p3f " + options);
        CHECK(r.status == 2);
        CHECK_THAT(r.err, ContainsSubstring(expected));
    }
    CHECK(f.etalon("render ball.p3f --integrator ao --max-distance 0").status == 2);
    CHECK(f.etalon("render ball.p3f --integrator ao --max-distance -1").status == 2);
}
