// Input and exit status of every subcommand.
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

TEST_CASE("The scene may come from standard input", "[app]") {
    const Folder f;
    CHECK(f.etalon("render - --format p3f -o a.exr -q", small_scene).status == 0);
    CHECK(f.has("a.exr"));
    CHECK(f.etalon("render - -q", small_scene).status == 0);
    CHECK(f.has("render.exr"));
    CHECK(f.etalon("info -", "x").status == 3);
    CHECK(f.etalon("info -", "sce1.0\neyepos 0 0 5\nball 1 0 0 0\n").status == 0);
}

TEST_CASE("Wrong usage ends with 2, an unusable scene with 3, an unwritable output with 4",
          "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    for (const char* wrong :
         {"", "paint ball.p3f", "render", "render ball.p3f --spp many", "render ball.p3f -b magic",
          "render ball.p3f --crop 1,2,3", "render ball.p3f --crop 0,0,99,5",
          "render ball.p3f --resolution 0x5", "render ball.p3f -o a.gif",
          "render ball.p3f --integrator bdpt", "render ball.p3f --aov M", "trace ball.p3f"}) {
        INFO(wrong);
        const auto r = f.etalon(wrong);
        CHECK(r.status == 2);
        CHECK(r.err + r.out != "");
    }
    f.write("empty.p3f", "");
    for (const char* unusable : {"missing.p3f", "empty.p3f", "."}) {
        INFO(unusable);
        const auto r = f.etalon(std::string("render ") + unusable);
        CHECK(r.status == 3);
        CHECK_THAT(r.err, ContainsSubstring("error:"));
    }
    for (const char* unwritable : {"-o no/such/place.exr", "-o a.exr --stats no/such/place.json"}) {
        const auto r = f.etalon(std::string("render ball.p3f ") + unwritable);
        CHECK(r.status == 4);
        CHECK_THAT(r.err, ContainsSubstring("no/such is not a directory"));
    }
    CHECK(!f.has("a.exr"));  // known before rendering
}

TEST_CASE("Diagnostics name file, line and column", "[app]") {
    const Folder f;
    f.write("odd.p3f", small_scene + "sphere 1 2 3 4\n");
    const auto r = f.etalon("render odd.p3f -q");
    CHECK(r.status == 0);
    CHECK_THAT(r.err, ContainsSubstring("odd.p3f:18:1: warning:"));
    CHECK(f.etalon("render odd.p3f -q --strict").status == 3);
}

TEST_CASE("only a format that has one is rendered as its old program did", "[app]") {
    const Folder f;
    f.write("a.nff", "v from 0 0 1 at 0 0 0 up 0 1 0 angle 9 hither 0 resolution 4 4\nl 0 0 1\n");
    f.write("a.prt", "from 0 0 1\nat 0 0 0\nup 0 1 0\nangle 9\nresolution 4 4\nlight 0 0 1\n");
    CHECK(f.etalon("info a.nff").status == 0);
    CHECK(f.etalon("info a.nff --legacy nff").status == 2);
    CHECK(f.etalon("info a.prt --legacy prt").status == 0);
    f.write("a.sce", "sce1.0\neyepos 0 0 5\nball 1 0 0 0\n");
    CHECK(f.etalon("info a.sce --legacy sce").status == 0);
    CHECK(f.etalon("info a.nff --legacy prt").status == 2);
}
