// --strict, --legacy, --one-sided.
#include "tests/catch.h"
#include "tests/formats/p3f_text.h"

using namespace etalon;

namespace {

LoadOptions strict() {
    LoadOptions options;
    options.strict = true;
    return options;
}
LoadOptions legacy() {
    LoadOptions options;
    options.legacy = true;
    return options;
}
LoadOptions one_sided() {
    LoadOptions options;
    options.one_sided = true;
    return options;
}

}  // namespace

TEST_CASE("strict makes errors of warnings, and of a scene with any none") {
    const LoadResult r = load_objects("s 0 0 0 0\ns 0 0 0 1", strict());
    CHECK_FALSE(r.scene);
    CHECK(messages(r) == Messages{"a.p3f:2:1: error: 's' left out: its radius is 0"});
    CHECK(load_objects("s 0 0 0 1", strict()).scene);
}

TEST_CASE("legacy shades as the course's programs of 2021 did") {
    const std::string text = "mat 0 0 0 1 1 0.5 1 0.5 10 0 1\nmat 0 0 0 0 1 1 1 0.5 10 1 1.5\n";
    const std::string lights = "l 0 0 0 1 1 1\nl 1 0 0 1 1 1\n";
    const LoadResult r = load_statements(text + lights, legacy());
    CHECK(messages(r).empty());
    CHECK(r.settings.whitted.schlick);
    CHECK(r.settings.whitted.clamp_each_ray);
    CHECK(r.settings.whitted.fixed_bias == 1e-3);
    CHECK(r.settings.max_depth == 6);
    CHECK(r.scene->whitted().materials[0].specular.x == Approx(0.5 / 2.5));
    CHECK(r.scene->whitted().materials[0].specular.y == Approx(0.25 / 2.5));
    CHECK(r.scene->whitted().materials[0].reflection == Color(0.5F, 0.25F, 0.5F));
    CHECK(r.scene->whitted().materials[1].absorption == Color(0.0F));
    CHECK(load_statements(text).scene->whitted().materials[1].absorption == Color(1.0F));
}

TEST_CASE("legacy without lights leaves the highlights alone") {
    const LoadResult r = load_statements("mat 0 0 0 1 1 1 1 0.5 10 0 1", legacy());
    CHECK(r.scene->whitted().materials[0].specular == Color(0.5F));
}

TEST_CASE("one-sided shows the front of every shape but those of negative radius") {
    const LoadResult r = load_objects(
        "s 0 0 0 1\nbox 0 0 0 1 1 1\npl 0 0 0 1 0 0 0 1 0\nnpl 0 0 1 0\nc 0 0 0 1 0 0 1 1\n"
        "p 3 0 0 0 1 0 0 0 1 0\np 4 0 0 0 1 0 0 1 1 0 0 1 0\npp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 "
        "0 1\n"
        "mesh 3 1 0 0 0 1 0 0 0 1 0 1 2 3\ns 0 0 0 -1\nc 0 0 0 -1 0 0 1 -1",
        one_sided());
    CHECK(messages(r).empty());
    REQUIRE(r.scene->geometry.primitives.size() == 11);
    for (std::size_t i = 0; i < 9; ++i)
        CHECK(r.scene->geometry.primitives[i].sides == Sides::front);
    CHECK(r.scene->geometry.primitives[9].sides == Sides::back);
    CHECK(r.scene->geometry.primitives[10].sides == Sides::back);
}

TEST_CASE("one-sided leaves glass its two sides, so that rays leave it again") {
    const LoadResult r = load_statements("mat 0 0 0 1 1 1 1 0.5 10 1 1.5\ns 0 0 0 1", one_sided());
    CHECK(r.scene->geometry.primitives[0].sides == Sides::both);
}
