// Output of etalon info.
#include <nlohmann/json.hpp>

#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

using nlohmann::json;

TEST_CASE("info shows the contents of a scene, as text and as JSON", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    CHECK_THAT(f.etalon("info ball.p3f").out,
               ContainsSubstring("1 sphere") && ContainsSubstring("32 x 24"));
    const json j = json::parse(f.etalon("info ball.p3f --json").out);
    CHECK(j["primitives"] == json{{"sphere", 1}, {"plane", 1}});
    CHECK(j["needs"] == json{"reflected rays"});
}

TEST_CASE("info shows what shapes of instances need", "[app]") {
    const Folder f;
    f.write("object.pbrt",
            "WorldBegin ObjectBegin \"a\" Shape \"trianglemesh\" \"integer indices\" [0 1 2] "
            "\"point P\" [0 0 0 1 0 0 0 1 0] \"normal N\" [0 0 1 0 1 1 1 0 1] ObjectEnd "
            "ObjectInstance \"a\" WorldEnd");
    CHECK(json::parse(f.etalon("info object.pbrt --json").out)["needs"] ==
          json{"interpolated normals"});
}

TEST_CASE("info shows the memory of texture images, from their headers", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    REQUIRE(f.etalon("render ball.p3f --resolution 32x32 -q -o square.png -o float.exr").status ==
            0);
    REQUIRE(f.etalon("render ball.p3f --resolution 30x20 -q -o odd.png").status == 0);
    const auto bytes = [&](const std::string& file) {
        f.write("textured.pbrt",
                "WorldBegin Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"" + file +
                    "\" Material \"matte\" \"texture Kd\" \"t\" Shape \"sphere\" WorldEnd");
        return json::parse(f.etalon("info textured.pbrt --json").out)["texture_memory_bytes"];
    };
    CHECK(bytes("square.png") == 32 * 32 * 3);
    CHECK(bytes("odd.png") == 32 * 32 * 4);
    CHECK(bytes("float.exr") == 32 * 32 * 12);
    CHECK(json::parse(f.etalon("info ball.p3f --json").out)["texture_memory_bytes"] == 0);
}
