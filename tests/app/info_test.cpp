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

TEST_CASE("--legacy reads a scene as the old program of its format did", "[app]") {
    const Folder f;
    const auto info = [&](const std::string& arguments) {
        return json::parse(f.etalon("info --json " + arguments).out);
    };
    f.write("ball.p3f", small_scene);
    CHECK(info("ball.p3f")["max_depth"] == 5);
    CHECK(info("ball.p3f --legacy p3f")["max_depth"] == 6);
    f.write("a.prt", "from 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nresolution 40 30\nlight 0 0 1\n");
    CHECK(info("a.prt")["camera"]["fov_degrees"] == 40.0);
    const double wide = info("a.prt --legacy prt")["camera"]["fov_degrees"];
    CHECK(wide == Approx(61.36411235));  // 2 atan(tan(40 degrees) / sqrt(2))
    f.write("a.sce",
            "sce1.0\neyepos 0 0 5\nrotate 45 1 0 0\n"
            "triangle 0 0 0  1 0 0  0 1 0\n");
    CHECK(info("a.sce")["primitives"] == json{{"triangle", 1}});
    CHECK(info("a.sce --legacy sce")["primitives"].empty());  // the matrix is singular
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

TEST_CASE("info says which images of a scene cannot be read", "[app]") {
    const Folder f;
    f.write("scene.pbrt",
            "WorldBegin LightSource \"infinite\" \"string mapname\" \"none.exr\"\n"
            "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"none.png\"\n"
            "Texture \"u\" \"spectrum\" \"imagemap\" Shape \"sphere\" WorldEnd");
    const auto r = f.etalon("info scene.pbrt --json");
    CHECK(r.status == 0);
    const json list = json::parse(r.out)["diagnostics"];
    REQUIRE(list.size() == 3);
    CHECK(list[0]["message"] == "'filename' is missing; grey stands in");
    CHECK(list[0]["line"] == 3);
    CHECK(list[1]["column"] == 12);
    CHECK(list[2]["line"] == 2);
    CHECK_THAT(r.err, ContainsSubstring("scene.pbrt:2:1: warning: none.png: cannot be read: "));
    const auto strict = f.etalon("info scene.pbrt --json --strict");
    CHECK(strict.status == 3);
    CHECK(json::parse(strict.out)["diagnostics"][0]["severity"] == "error");
}

TEST_CASE("info and --stats tell direct lighting from whole paths", "[app]") {
    const Folder f;
    const auto is_direct = [&](const std::string& integrator, const std::string& options = "") {
        f.write("scene.pbrt",
                "Integrator \"" + integrator + "\" WorldBegin Shape \"sphere\" WorldEnd");
        REQUIRE(
            f.etalon("render scene.pbrt --resolution 4x4 --spp 1 -q --stats s" + options).status ==
            0);
        return json::parse(f.read("s"))["direct_lighting"].get<bool>();
    };
    for (const std::string integrator : {"directlighting", "whitted", "path", "volpath"}) {
        const bool expected = integrator == "directlighting" || integrator == "whitted";
        CHECK(is_direct(integrator) == expected);
        CHECK_FALSE(is_direct(integrator, " --integrator path"));
        CHECK(json::parse(f.etalon("info scene.pbrt --json").out)["direct_lighting"] == expected);
    }
}
