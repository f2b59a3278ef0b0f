#include <variant>

#include "tests/catch.h"
#include "tests/formats/p3f_text.h"

using namespace etalon;

TEST_CASE("point lights of both dialects are read") {
    for (const std::string keyword : {"light punctual", "l"}) {
        const LoadResult r = load_statements(keyword + " 1 2 3 0.25 0.5 1");
        CHECK(messages(r).empty());
        REQUIRE(r.scene->whitted().lights.size() == 1);
        const auto& light = std::get<PointLight>(r.scene->whitted().lights[0]);
        CHECK(light.position == Vec3(1, 2, 3));
        CHECK(light.color == Color(0.25F, 0.5F, 1));
    }
}

TEST_CASE("a quad light is a corner and the ends of two edges") {
    const LoadResult r = load_statements("light quad 4 3 2 1 0.5 0.25 4 2 2 3 3 2 16");
    CHECK(messages(r).empty());
    REQUIRE(r.scene->whitted().lights.size() == 1);
    const auto& light = std::get<QuadLight>(r.scene->whitted().lights[0]);
    CHECK(light.corner == Vec3(4, 3, 2));
    CHECK(light.edge1 == Vec3(0, -1, 0));
    CHECK(light.edge2 == Vec3(-1, 0, 0));
    CHECK(light.color == Color(1, 0.5F, 0.25F));
    CHECK(light.samples == 16);
}

TEST_CASE("a quad light takes at least one sample and not absurdly many") {
    const std::string quad = "light quad 4 3 2 1 1 1 4 2 2 3 3 2 ";
    const LoadResult none = load_statements(quad + "0");
    CHECK(messages(none) ==
          Messages{"a.p3f:1:36: warning: expected 1 to 65536 light samples, found 0; "
                   "taken as 1"});
    CHECK(std::get<QuadLight>(none.scene->whitted().lights[0]).samples == 1);
    const LoadResult many = load_statements(quad + "999999999999");
    CHECK(std::get<QuadLight>(many.scene->whitted().lights[0]).samples == 65536);
}

TEST_CASE("a quad light of edges longer than any number is left out") {
    const LoadResult r = load_statements("light quad -1e308 5 5 1 1 1 1e308 5 5 0 1e308 5 4");
    CHECK(messages(r) == Messages{"a.p3f:1:1: warning: 'light' left out: its edges are too long"});
    CHECK(r.scene->whitted().lights.empty());
}

TEST_CASE("an unknown kind of light is reported with the nearest known one") {
    const LoadResult r = load_statements("light punctal 1 2 3 1 1 1\nl 0 0 0 1 1 1");
    CHECK(messages(r) ==
          Messages{"a.p3f:1:7: warning: expected punctual or quad after 'light', found "
                   "'punctal'; did you mean 'punctual'?"});
    CHECK(r.scene->whitted().lights.size() == 1);
}

TEST_CASE("a light that breaks off is left out") {
    const LoadResult r = load_statements("l 1 2 3 1\nl 0 0 0 1 1 1");
    CHECK(messages(r) ==
          Messages{"a.p3f:2:1: warning: expected a number for the colour of 'l', found 'l'"});
    CHECK(r.scene->whitted().lights.size() == 1);
}

TEST_CASE("a light at no place is left out") {
    for (const std::string value : {"nan", "-inf", "1e400"}) {
        const LoadResult r = load_statements("l 1 " + value + " 3 1 1 1\nl 0 0 0 1 1 1");
        REQUIRE(r.diagnostics.size() == 1);
        CHECK(r.diagnostics[0].line == 1);
        CHECK(r.diagnostics[0].column == 5);
        CHECK(r.diagnostics[0].kind == "range");
        CHECK(r.scene->whitted().lights.size() == 1);
    }
}
