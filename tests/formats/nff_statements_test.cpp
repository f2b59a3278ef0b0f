// v, b and l, and misplaced words.
#include "tests/catch.h"
#include "tests/formats/nff_text.h"

using namespace etalon;

TEST_CASE("an NFF camera is read") {
    const LoadResult r = load_text(
        "nff", "v\nfrom 1 2 3\nat 4 5 6\nup 0 0 1\nangle 50\nhither 0\nresolution 800 600\n");
    CHECK(messages(r).empty());
    REQUIRE(r.scene);
    CHECK(r.scene->format == "nff");
    CHECK(r.settings.display_colors);
    CHECK(r.settings.max_depth == 5);
    CHECK(r.settings.samples_per_pixel == 0);
    const Camera& c = r.scene->camera;
    CHECK(c.eye == Vec3(1, 2, 3));
    CHECK(c.at == Vec3(4, 5, 6));
    CHECK(c.up == Vec3(0, 0, 1));
    CHECK(c.fov_degrees == 50);
    CHECK(r.settings.resolution.x == 800);
    CHECK(r.settings.resolution.y == 600);
    CHECK(c.aperture == 0);
}

TEST_CASE("an NFF camera has no lens, and needs its lines by their names") {
    CHECK(messages(load_text("nff", good_view + "focal 2")) ==
          Messages{"a.nff:8:1: warning: 'focal' is not part of a camera"});
    CHECK(messages(load_text("nff", "v from 0 0 1 at 0 0 0 up 0 1 0 resolution 9 9")) ==
          Messages{"a.nff:1:1: error: the camera has no angle, so nothing can be rendered"});
    CHECK(messages(load_text("nff", "v at 0 0 0 up 0 1 0 angle 9 resolution 9 9")) ==
          Messages{"a.nff:1:1: error: the camera has no from, so nothing can be rendered"});
    CHECK(messages(load_text("nff", "b 0 0 0")) ==
          Messages{"a.nff:1:8: error: no camera, so nothing can be rendered"});
}

TEST_CASE("an NFF background may stand before the camera and after it") {
    CHECK(load_nff_text("b 0.25 0.5 1").scene->whitted().environment.background ==
          Color(0.25F, 0.5F, 1));
    const LoadResult r = load_text("nff", good_view + "b 0.25 0.5 1");
    CHECK(messages(r).empty());
    CHECK(r.scene->whitted().environment.background == Color(0.25F, 0.5F, 1));
}

TEST_CASE("NFF lights without colour are white and share their strength") {
    for (int n = 1; n <= 4; ++n) {
        std::string text;
        for (int i = 0; i < n; ++i) text += "l 1 2 " + std::to_string(i) + "\n";
        const LoadResult r = load_nff_text(text);
        CHECK(messages(r).empty());
        REQUIRE(r.scene->whitted().lights.size() == static_cast<std::size_t>(n));
        const auto& last = std::get<PointLight>(r.scene->whitted().lights.back());
        CHECK(last.position == Vec3(1, 2, n - 1));
        CHECK(last.color.x == Approx(1 / std::sqrt(n)));
        CHECK(last.color.y == last.color.x);
        CHECK(last.color.z == last.color.x);
    }
}

TEST_CASE("an NFF light with a colour has that colour, and counts among the lights") {
    const LoadResult r = load_nff_text("l 1 2 3 0.5 2 1\nl 0 0 1\nl 0 0 2 1 1 1\nl 0 0 3");
    CHECK(messages(r).empty());
    REQUIRE(r.scene->whitted().lights.size() == 4);
    const auto color = [&](int i) {
        return std::get<PointLight>(r.scene->whitted().lights[i]).color;
    };
    CHECK(color(0) == Color(0.5F, 2, 1));
    CHECK(color(1) == Color(0.5F));
    CHECK(color(2) == Color(1.0F));
    CHECK(color(3) == Color(0.5F));
}

TEST_CASE("an NFF light that breaks off is left out") {
    CHECK(messages(load_nff_text("l 1 2\nl 1 2 3 1 1\ns 0 0 0 1")) ==
          Messages{
              "a.nff:2:1: warning: expected a number for the position of 'l', found 'l'",
              "a.nff:3:1: warning: expected a number for the colour of 'l', found 's'",
              "a.nff:3:1: warning: 's' before any material; it gets a default one",
          });
}

TEST_CASE("words that are not NFF are reported and skipped") {
    const LoadResult r = load_nff_text("b 0 0 0 7\nf 1 1 1 1 0 0 0 0\nbox 0 0 0 1 1 1\ns 0 0 0 1");
    CHECK(messages(r) == Messages{"a.nff:1:9: warning: expected a keyword after 'b', found '7'",
                                  "a.nff:3:1: warning: unknown keyword 'box' (words skipped: 7)"});
    CHECK(r.scene->geometry.primitives.size() == 1);
    LoadOptions strict;
    strict.strict = true;
    CHECK_FALSE(load_nff_text("b 0 0 0 7", strict).scene);
}
