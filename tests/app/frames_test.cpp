// Files of several frames: which one is rendered, and the messages about it.
#include <nlohmann/json.hpp>

#include "core/image/io.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

const std::string first =
    "Film \"image\" \"integer xresolution\" 16 \"integer yresolution\" 8\n"
    "Sampler \"random\" \"integer pixelsamples\" 2\n"
    "WorldBegin\nTranslate 0 0 5\nMaterial \"mirror\"\nShape \"sphere\"\n"
    "LightSource \"infinite\"\nWorldEnd\n";

// It has none of the first frame's options and attributes.
const std::string second =
    "Film \"image\" \"integer xresolution\" 9 \"integer yresolution\" 7\n"
    "WorldBegin\nLightSource \"distant\"\nShape \"disk\" \"float height\" 2\n"
    "Shape \"disk\" \"float height\" 3\nWorldEnd\n";

/// A folder with a file of both frames and one of each.
struct FramesFolder : Folder {
    FramesFolder() {
        write("both.pbrt", first + second);
        write("first.pbrt", first);
        write("second.pbrt", second);
    }
};

std::vector<float> rendered(const Folder& f, const std::string& arguments) {
    const auto r = f.etalon("render " + arguments + " -q -o now.exr");
    INFO(arguments << "\n" << r.err);
    REQUIRE(r.status == 0);
    const auto image = etalon::read_image(f.path("now.exr"));
    REQUIRE(image.error == "");
    return std::get<std::vector<float>>(image.value.pixels);
}

}  // namespace

TEST_CASE("--frame renders a frame as if it were a file of its own", "[app]") {
    const FramesFolder f;
    CHECK(rendered(f, "both.pbrt --strict --frame 1") == rendered(f, "first.pbrt"));
    CHECK(rendered(f, "both.pbrt --strict --frame 2") == rendered(f, "second.pbrt"));
    CHECK(rendered(f, "first.pbrt --frame 1").size() == 16 * 8 * 3);
    CHECK(rendered(f, "second.pbrt").size() == 9 * 7 * 3);
}

TEST_CASE("without --frame the first frame is rendered, with a warning about the others", "[app]") {
    const FramesFolder f;
    CHECK(rendered(f, "both.pbrt") == rendered(f, "first.pbrt"));
    const std::string said =
        "2 frames in one file, of which this is the first; --frame N chooses another\n";
    CHECK(f.etalon("render both.pbrt -q").err == "both.pbrt: warning: " + said);
    const auto strict = f.etalon("render both.pbrt --strict");
    CHECK(strict.status == 3);
    CHECK(strict.err == "both.pbrt: error: " + said);
}

TEST_CASE("info shows the number of frames, and which one it describes", "[app]") {
    const FramesFolder f;
    const json shown = json::parse(f.etalon("info both.pbrt --frame 2 --json").out);
    CHECK(shown["frame"] == 2);
    CHECK(shown["frames"] == 2);
    CHECK(shown["camera"]["width"] == 9);
    CHECK(shown["diagnostics"].empty());
    CHECK_THAT(f.etalon("info both.pbrt").out, ContainsSubstring("frame       1 of 2\n"));
    f.write("ball.p3f", small_scene);
    CHECK(json::parse(f.etalon("info ball.p3f --frame 1 --json").out)["frames"] == 1);
}

TEST_CASE("a frame that is not there is a mistake of the command line", "[app]") {
    const FramesFolder f;
    f.write("ball.p3f", small_scene);
    for (const std::string command :
         {"render both.pbrt", "info both.pbrt --json", "convert both.pbrt -o a.pbrt"}) {
        INFO(command);
        const auto r = f.etalon(command + " --frame 3");
        CHECK(r.status == 2);
        CHECK(r.out == "");
        CHECK(r.err == "etalon: error: --frame 3: both.pbrt holds 2 frames; expected 1 to 2\n");
    }
    CHECK(f.etalon("render ball.p3f --frame 2").err ==
          "etalon: error: --frame 2: ball.p3f holds one frame\n");
    for (const char* wrong : {"0", "-1", "1001", "1.5", "last"}) {
        INFO(wrong);
        const auto r = f.etalon(std::string("render both.pbrt --frame ") + wrong);
        CHECK(r.status == 2);
        CHECK_THAT(r.err, ContainsSubstring("--frame"));
    }
    CHECK_FALSE(f.has("a.pbrt"));
    CHECK_FALSE(f.has("both.exr"));
}

TEST_CASE("convert writes all frames, or the requested one", "[app]") {
    const FramesFolder f;
    const auto converted = [&](const std::string& arguments) {
        const auto r = f.etalon("convert " + arguments + " --strict -o now.pbrt");
        CHECK(r.status == 0);
        CHECK(r.err == "");
        return f.read("now.pbrt");
    };
    const std::string one = converted("first.pbrt"), other = converted("second.pbrt");
    CHECK(converted("both.pbrt") == one + other);
    CHECK(converted("both.pbrt --frame 1") == one);
    CHECK(converted("both.pbrt --frame 2") == other);
}
