// etalon trace: reads rays and writes hits.
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

TEST_CASE("trace answers ray by ray", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    f.write("rays.txt",
            "# a comment\n"
            "0 0 5 0 0 -1\n"
            "0 0 5 0 0 -0x1p1 # twice as fast\n"
            "0 0 5 0 0 -1 0 3.9999999999999996\n"
            "0 0 5 0 0 -1 0 4\n"
            "0 0 5 0 0 -1 -inf inf\n"
            "\n"
            "0 9 0 0 1 0\n"
            "5 5 0 0 -1 0\n");
    for (const char* backend : {"none", "grid", "bvh", "embree", "embree-user"}) {
        const auto r = f.etalon(std::string("trace ball.p3f --rays rays.txt -b ") + backend);
        CHECK(r.status == 0);
        CHECK(r.out ==
              "hit 4 sphere 1 0 0 1\n"
              "hit 2 sphere 1 0 0 1\n"
              "miss\n"
              "hit 4 sphere 1 0 0 1\n"
              "hit 4 sphere 1 0 0 1\n"
              "miss\n"
              "hit 6 plane 0 0 -1 0\n");
    }
}

TEST_CASE("A ray of a file passes where a shadowalpha is 0 if it is marked as a shadow ray",
          "[app]") {
    const Folder f;
    f.write("triangle.pbrt",
            "Camera \"perspective\" WorldBegin Shape \"trianglemesh\" \"point P\" "
            "[-1 -1 0 1 -1 0 0 2 0] \"integer indices\" [0 1 2] \"float shadowalpha\" 0 WorldEnd");
    f.write("rays.txt",
            "0 0 5 0 0 -1\n"
            "0 0 5 0 0 -1 shadow\n"
            "0 0 5 0 0 -1 0 9 0.5\tshadow # to the light\n"
            "0 0 5 0 0 -1 0 9\n");
    const auto r = f.etalon("trace triangle.pbrt --rays rays.txt");
    CHECK(r.out == "hit 5 triangle 0 0 0 1\nmiss\nmiss\nhit 5 triangle 0 0 0 1\n");
    CHECK(f.etalon("trace triangle.pbrt --shadow --rays rays.txt").out ==
          "miss\nmiss\nmiss\nmiss\n");
}

TEST_CASE("trace reports the position of an error in a file of rays", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    const std::pair<const char*, const char*> wrong[] = {
        {"0 0 5 0 0\n", ":1:1: error: wrong count of numbers; expected 'ox oy oz"},
        {"\n0 0 5  0 1x 1\n", ":2:10: error: not a number; expected 'ox oy oz"},
        {"# rays\n\n 0 0 5 # no more\n", ":3:2: error: wrong count of numbers"},
        {"0 0 5 0 0 1 0 1 1\n", ":1:17: error: time outside of [0, 1)"},
        {"0 0 5 0 0 1 shadow 0\n", ":1:20: error: something after 'shadow'"},
        {"0 nan 5 0 0 1\n", ":1:3: error: not a finite number"},
        {"0 0 5 0 0 -1e400\n", ":1:11: error: not a finite number"},
        {"0 0 5 0 0 1 nan 2\n", ":1:13: error: not a number"},
        {"0 0 5 0 0 1 0 nan\n", ":1:15: error: not a number"},
        {"0 0 5 0 -0 0\n", ":1:7: error: a direction of length 0"},
        {"shadow\n", ":1:1: error: wrong count of numbers"},
        {"0 0 5 0 0 1 shadows\n", ":1:13: error: not a number"}};
    for (const auto& [rays, error] : wrong) {
        f.write("bad.txt", rays);
        const auto r = f.etalon("trace ball.p3f --rays bad.txt");
        CHECK(r.status == 3);
        CHECK(r.out == "");
        CHECK_THAT(r.err, ContainsSubstring(std::string("bad.txt") + error));
    }
    CHECK(f.etalon("trace ball.p3f --rays bad.txt -o no/such/hits.txt").status == 4);
    for (const std::string after : {"", "5 6"}) {
        f.write("bad.txt", "0 0 5 0 0 -1 " + std::string(1, '\0') + after + "\n");
        const auto nul = f.etalon("trace ball.p3f --rays bad.txt");
        CHECK(nul.status == 3);
        CHECK_THAT(nul.err, ContainsSubstring(":1:14: error: not a number"));
    }
}

TEST_CASE("A file of rays may begin with a byte order mark", "[app]") {
    const Folder f;
    f.write("ball.p3f", small_scene);
    f.write("rays.txt",
            "\xEF\xBB\xBF"
            "0 0 5 0 0 -1\n");
    CHECK(f.etalon("trace ball.p3f --rays rays.txt").out == "hit 4 sphere 1 0 0 1\n");
    f.write("rays.txt",
            "\xEF\xBB\xBF"
            "0 0 5 x\n");
    CHECK_THAT(f.etalon("trace ball.p3f --rays rays.txt").err, ContainsSubstring(":1:7: error: "));
}

TEST_CASE("An interrupted trace writes the hits until then", "[app]") {
    const Folder f;
    constexpr int count = 20'000;
    std::string scene = small_scene, rays;
    for (int i = 0; i < 10'000; ++i) scene += "s 0 0 -9 0.1\n";
    for (int i = 0; i < count; ++i) rays += "0 0 5 0 0 -1\n";
    f.write("balls.p3f", scene);
    f.write("rays.txt", rays);
    const auto r = interrupted(f, "etalon trace balls.p3f --rays rays.txt -b none -o hits.txt",
                               has_worked(40));
    CHECK(r.status == 130);
    const std::string hits = f.read("hits.txt"), hit = "hit 4 sphere 1 0 0 1\n";
    CHECK(hits.size() > hit.size());
    CHECK(hits.size() < count * hit.size());
    CHECK(hits.size() % hit.size() == 0);
}
