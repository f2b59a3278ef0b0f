// Values of options: numbers at their limits, and none at all.
#include <nlohmann/json.hpp>

#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

using nlohmann::json;

TEST_CASE("Whole numbers are decimal, whatever zeros they begin with", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    REQUIRE(f.etalon("render ball.p3f -q --spp 010 --seed 0018 -t 02 --resolution 08x09 "
                     "-o a.exr --stats s.json")
                .status == 0);
    const json s = json::parse(f.read("s.json"));
    CHECK(s["image"] == json{{"width", 8}, {"height", 9}, {"spp", 10}, {"seed", 18}});
    CHECK(s["threads"] == 2);
    for (const char* wrong : {"--spp 0x10", "--seed 1e3", "--spp -0x1", "--threads 2x"}) {
        INFO(wrong);
        const auto r = f.etalon(std::string("render ball.p3f ") + wrong);
        CHECK(r.status == 2);
        CHECK_THAT(r.err, ContainsSubstring("expected a whole number"));
    }
}

TEST_CASE("Numbers beyond 32 bits do not wrap around", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    for (const char* wrong : {"--resolution 16x4294967312", "--resolution 4294967328x4294967328",
                              "--crop 0,0,4294967300,4294967300", "--spp 4 --part 1/4294967298",
                              "--spp 4 --part 4294967297/4294967298"}) {
        INFO(wrong);
        CHECK(f.etalon(std::string("render ball.p3f -o a.exr ") + wrong).status == 2);
    }
}

TEST_CASE("An empty value is none", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    for (const char* option : {"--stats", "--reference", "--checkpoint", "--crop", "--part",
                               "--resolution", "--filter", "--root", "--max-memory"}) {
        const auto r = f.etalon(std::string("render ball.p3f -o a.exr ") + option + " ''");
        CAPTURE(option, r.err);
        CHECK(r.status == 2);
        CHECK_FALSE(f.has("a.exr"));
    }
}
