// Where results say they come from, from outside.
#include <nlohmann/json.hpp>

#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

using nlohmann::json;

namespace {

void check_provenance(const json& j, const std::string& command) {
    CHECK(j["schema"] == 1);
    CHECK(j["version"].get<std::string>().find('.') != std::string::npos);
    CHECK_FALSE(j["commit"].get<std::string>().empty());
    CHECK_FALSE(j["compiler"].get<std::string>().empty());
    CHECK_THAT(j["command"].get<std::string>(), ContainsSubstring(command));
    CHECK_FALSE(j["embree"]["version"].get<std::string>().empty());
}

}  // namespace

TEST_CASE("the same render twice gives equal files", "[app]") {
    const Folder f;
    f.write("a.p3f", small_scene);
    for (const std::string name : {"x", "y"}) {
        const std::string outputs = " -o " + name + ".exr -o " + name + ".png";
        REQUIRE(f.etalon("render a.p3f --spp 2 -q" + outputs).status == 0);
    }
    CHECK(f.read("x.exr") == f.read("y.exr"));
    CHECK(f.read("x.png") == f.read("y.png"));
}

TEST_CASE("a PNG says what made it of which scene, as an EXR does", "[app]") {
    const Folder f;
    f.write("a.p3f", small_scene);
    REQUIRE(f.etalon("render a.p3f --spp 2 --seed 77 -q -o a.exr -o a.png").status == 0);
    for (const char* text : {"Etalon ", "scene", "a.p3f", "seed", "77", "samplesPerPixel"}) {
        INFO(text);
        CHECK_THAT(f.read("a.png"), ContainsSubstring(text));
        CHECK_THAT(f.read("a.exr"), ContainsSubstring(text));
    }
}

TEST_CASE("stats and measurements say which program made them, and how it was called", "[app]") {
    const Folder f;
    f.write("a scene.p3f", small_scene);
    REQUIRE(f.etalon("render 'a scene.p3f' -q -o a.png --stats s.json").status == 0);
    check_provenance(json::parse(f.read("s.json")),
                     "etalon render 'a scene.p3f' -q -o a.png --stats s.json");
    REQUIRE(f.shell("exec '" ETALON_BINARY_DIR
                    "/bin/etalon-bench' frames 'a scene.p3f' --repeat 1 --json f.json")
                .status == 0);
    check_provenance(json::parse(f.read("f.json")),
                     "etalon-bench frames 'a scene.p3f' --repeat 1 --json f.json");
}

TEST_CASE("--version says the commit and the compiler", "[app]") {
    const Folder f;
    const std::string out = f.etalon("--version").out;
    CHECK_THAT(out, ContainsSubstring("etalon ") && ContainsSubstring("\ncommit ") &&
                        ContainsSubstring("\ncompiler ") && ContainsSubstring("\nflags "));
}
