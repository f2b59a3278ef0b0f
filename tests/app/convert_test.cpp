// etalon convert as a process: equivalent files, and warnings about features that are lost.
#include <filesystem>

#include "core/image/io.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/formats/shared_scenes.h"

using namespace etalon::test;
namespace fs = std::filesystem;

namespace {

std::vector<float> image(const Folder& f, const std::string& scene) {
    const auto r = f.etalon("render '" + scene + "' --resolution 60x40 -q -o now.exr --spp 2");
    INFO(r.err);
    REQUIRE(r.status == 0);
    const auto image = etalon::read_image(f.path("now.exr"));
    REQUIRE(image.error == "");
    return std::get<std::vector<float>>(image.value.pixels);
}

void check_same_image(const Folder& f, const std::string& scene) {
    INFO(scene);
    const auto r = f.etalon("convert '" + scene + "' -o again.p3f");
    CHECK(r.status == 0);
    CHECK(r.out + r.err == "");
    CHECK((image(f, scene) == image(f, "again.p3f")));
}

}  // namespace

TEST_CASE("a P3F scene of every feature gives the same image when it is written again", "[app]") {
    const Folder f;
    for (const auto& entry : fs::directory_iterator(ETALON_SOURCE_DIR "/scenes/features")) {
        if (entry.path().extension() == ".p3f") check_same_image(f, entry.path().string());
    }
}

TEST_CASE("every real P3F scene gives the same image when it is written again",
          "[needs_shared_scenes][long]") {
    const Folder f;
    const std::vector<std::string> paths = etalon::shared_scenes("p3f", ".p3f");
    SKIP_UNLESS(!paths.empty(), "no P3F scenes in " << etalon::shared_scenes_folder());
    for (const std::string& path : paths) {
        if (path.find("stray") == std::string::npos) check_same_image(f, path);
    }
}

TEST_CASE("convert lists lost features, each kind once with a count", "[app]") {
    const Folder f;
    f.write("a.sce", "ball 1 0 0 -9\nscale 1 1 2\nball 1 0 0 -9\nball 1 1 0 -9\n");
    const auto p3f = f.etalon("convert a.sce -o a.p3f");
    CHECK(p3f.status == 0);
    CHECK(p3f.out == "");
    CHECK(p3f.err ==
          "a.sce: warning: P3F cannot express ambient colour of a material (1)\n"
          "a.sce: warning: P3F cannot express ellipsoid, now polygons (2)\n");
    CHECK(f.etalon("render a.p3f --strict -q -o a.exr").status == 0);
    const auto pbrt = f.etalon("convert a.sce -o a.pbrt");
    CHECK(pbrt.status == 0);
    CHECK_THAT(pbrt.err,
               ContainsSubstring(
                   "a.sce: warning: PBRT cannot express ambient colour of a material (1)\n"));
    CHECK_THAT(f.read("a.pbrt"), ContainsSubstring("WorldEnd"));
    const auto strict = f.etalon("convert a.sce --strict -o b.p3f");
    CHECK(strict.status == 3);
    CHECK_THAT(strict.err, ContainsSubstring("a.sce: error: P3F cannot express ellipsoid"));
    CHECK_FALSE(f.has("b.p3f"));
}

TEST_CASE("PBRT is written as PBRT with all its contents", "[app]") {
    const Folder f;
    f.shell("mkdir in out");
    f.write("in/part.pbrt", "Shape \"plymesh\" \"string filename\" \"m.ply\"\n");
    f.write("in/a.pbrt",
            "Integrator \"bdpt\" WorldBegin AttributeBegin Material \"hair\" Include \"part.pbrt\" "
            "AttributeEnd WorldEnd");
    const auto r = f.etalon("convert in/a.pbrt -o out/b.pbrt");
    CHECK(r.err == "");
    CHECK(r.status == 0);
    CHECK_THAT(f.read("out/b.pbrt"), ContainsSubstring("Integrator \"bdpt\""));
    CHECK_THAT(f.read("out/b.pbrt"), ContainsSubstring("\"string type\" \"hair\""));
    CHECK_THAT(f.read("out/b.pbrt"), ContainsSubstring("\"../in/m.ply\""));
    CHECK(f.etalon("convert out/b.pbrt -o out/c.pbrt").status == 0);
    CHECK(f.read("out/c.pbrt") == f.read("out/b.pbrt"));
    CHECK(f.etalon("convert - -o out/d.pbrt", f.read("out/b.pbrt")).status == 0);
    CHECK_THAT(f.read("out/d.pbrt"), ContainsSubstring("\"hair\""));
}

TEST_CASE("every shape of PBRT gives the same image when it is written again", "[app]") {
    const Folder f;
    const fs::path source = ETALON_SOURCE_DIR;
    for (const fs::path& folder : {source / "scenes/pbrt", source / "tests/render/references"}) {
        for (const auto& entry : fs::directory_iterator(folder)) {
            if (entry.path().extension() != ".pbrt") continue;
            CAPTURE(entry.path());
            const auto r = f.etalon("convert '" + entry.path().string() + "' -o again.pbrt");
            CHECK(r.status == 0);
            CHECK(r.out + r.err == "");
            CHECK((image(f, entry.path().string()) == image(f, "again.pbrt")));
        }
    }
}

TEST_CASE("PBRT at which pbrt-v3 stops is not written again", "[app]") {
    const Folder f;
    f.write("fatal.pbrt", "WorldBegin Shpae \"sphere\" WorldEnd");
    f.write("odd.pbrt", "WorldBegin Shape \"sphere\" \"float radios\" 3 WorldEnd");
    const auto fatal = f.etalon("convert fatal.pbrt -o a.pbrt");
    CHECK(fatal.status == 3);
    CHECK_THAT(fatal.err, ContainsSubstring("fatal.pbrt:1:12: error: expected a directive"));
    CHECK(f.etalon("convert odd.pbrt --strict -o a.pbrt").status == 3);
    CHECK_FALSE(f.has("a.pbrt"));
    CHECK(f.etalon("convert odd.pbrt -o a.pbrt").status == 0);
    CHECK_THAT(f.read("a.pbrt"), ContainsSubstring("Shape \"sphere\"\n"));
}

TEST_CASE("convert refuses to overwrite its source", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    f.shell("ln -s ball.p3f link.p3f; ln ball.p3f hard.p3f");
    for (const char* output : {"ball.p3f", "./ball.p3f", "link.p3f", "hard.p3f"}) {
        const auto r = f.etalon(std::string("convert ball.p3f -o ") + output);
        CHECK(r.status == 2);
        CHECK_THAT(r.err, ContainsSubstring("is an input, which would be lost"));
    }
    CHECK(f.read("ball.p3f") == small_scene);
}

TEST_CASE("a convert that a signal ends while it writes leaves no temporary file", "[app]") {
    const Folder f;
    std::string scene = small_scene;
    for (int i = 0; i < 1'000'000; ++i) {
        scene += "s 0.123456789 0.123456789 -9.123456789 0.123456789\n";
    }
    f.write("many.p3f", scene);
    // The shell looks for the temporary file without starting programs, so that it is in time.
    const auto r = f.shell("'" ETALON_BINARY_DIR
                           "/bin/etalon' convert many.p3f -o b.p3f & pid=$!; until set -- "
                           ".etalon-*; test -e \"$1\" || "
                           "! kill -0 $pid; do :; done; kill -TERM $pid; wait $pid");
    INFO(r.err);
    CHECK(r.status == 143);
    CHECK(f.shell("ls -A").out == "b.p3f\nmany.p3f\n");
}

TEST_CASE("a skybox is found from where the new file is", "[app]") {
    const Folder f;
    f.shell("mkdir new");
    CHECK(f.etalon("convert " ETALON_SOURCE_DIR "/scenes/features/skybox.p3f -o new/sky.p3f")
              .status == 0);
    CHECK(f.etalon("render new/sky.p3f --strict --resolution 8x6 --spp 1 -q -o a.exr").err == "");
}

TEST_CASE("convert exits with the documented status", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    f.write("bad.p3f", small_scene + "ball 1 2\n");
    CHECK(f.etalon("convert ball.p3f").status == 2);
    const auto unknown = f.etalon("convert ball.p3f -o ball.obj");
    CHECK(unknown.status == 2);
    CHECK_THAT(unknown.err, ContainsSubstring(".pbrt or .p3f"));
    CHECK(f.etalon("convert missing.p3f -o a.p3f").status == 3);
    CHECK(f.etalon("convert bad.p3f --strict -o a.p3f").status == 3);
    CHECK_FALSE(f.has("a.p3f"));
    CHECK(f.etalon("convert ball.p3f -o no/such/a.p3f").status == 4);
    CHECK(f.etalon("convert - --format p3f -o a.p3f", small_scene).status == 0);
    CHECK(f.shell("ls -A").out == "a.p3f\nbad.p3f\nball.p3f\n");
}
