// f, s, c, p and pp.

#include <algorithm>
#include <cmath>

#include "tests/catch.h"
#include "tests/formats/corners.h"
#include "tests/formats/nff_text.h"

using namespace etalon;

namespace {

LoadOptions one_sided() {
    LoadOptions options;
    options.one_sided = true;
    return options;
}

const std::string matt = "f 1 1 1 1 0 100000 0 0\n";
const std::string glass = "f 1 1 1 0.1 0.1 10 0.9 1.5\n";

Material material_of(const std::string& statement) {
    const LoadResult r = load_nff_text(statement);
    CAPTURE(statement);
    CHECK(messages(r).empty());
    REQUIRE(r.scene->whitted().materials.size() == 1);
    return r.scene->whitted().materials[0];
}

/// A star of `points` points about the origin: concave.
std::string star(int points) {
    std::string text = "p " + std::to_string(2 * points) + "\n";
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = 3.14159265358979 * i / points, radius = i % 2 == 0 ? 1 : 0.5;
        text += std::to_string(radius * std::cos(angle)) + " " +
                std::to_string(radius * std::sin(angle)) + " 1\n";
    }
    return text;
}

}  // namespace

TEST_CASE("an NFF surface is matt in its colour and mirrors white") {
    const Material m = material_of("f 1 0.5 0.25 0.5 0.25 3.0827 0 1");
    CHECK(m.ambient == Color(0.0F));
    CHECK(m.diffuse == Color(0.5F, 0.25F, 0.125F));
    CHECK(m.specular == Color(0.25F));
    CHECK(m.reflection == Color(0.25F));
    CHECK(m.shininess == 3.0827);
    CHECK(m.highlight == Highlight::phong);
    CHECK(m.transmission == Color(0.0F));
    CHECK_FALSE(m.fresnel);
    CHECK(m.absorption == Color(0.0F));
}

TEST_CASE("an NFF surface lets any part of the light through, by no other law than Snell's") {
    const Material m = material_of("f 1 0.6 0.4 0.2 0 100000 0.8 1.1");
    CHECK(m.transmission == Color(0.8F));
    CHECK(m.ior == 1.1);
    CHECK(m.reflection == Color(0.0F));
    CHECK_FALSE(m.fresnel);
}

TEST_CASE("an opaque NFF surface may have an index of refraction of 0") {
    const Material m = material_of("f 1 0.75 0.33 0.8 0 100000 0 0");
    CHECK(m.specular == Color(0.0F));
    CHECK(m.shininess == 100000);
    CHECK(m.ior == 1);
}

TEST_CASE("an NFF surface that cannot be is left out") {
    const auto kept = [](const std::string& numbers) {
        const LoadResult r = load_nff_text(matt + "f " + numbers + "\ns 0 0 0 1");
        REQUIRE(r.diagnostics.size() == 1);
        CHECK(r.diagnostics[0].line == 2);
        CHECK(r.scene->whitted().materials.size() == 1);
        return r.diagnostics[0].message;
    };
    CHECK(kept("1 1 1 1 1 1 1 0") == "the index of refraction of glass is 0; expected more than 0");
    CHECK(kept("1 1 1 1 1 -1 0 1") == "the Shine is -1; expected 0 or more");
    CHECK(kept("1e30 1 1 1e30 1 1 0 1") == "a colour times its weight is too large for a colour");
    CHECK(kept("1 1 1 1 1e300 1 0 1") == "a colour times its weight is too large for a colour");
    CHECK(kept("1 1 1 1 1 1 1e300 1") == "a colour times its weight is too large for a colour");
}

TEST_CASE("an NFF object before any surface gets a grey one, with a warning") {
    const LoadResult r = load_nff_text("s 0 0 0 1");
    CHECK(messages(r) ==
          Messages{"a.nff:1:1: warning: 's' before any material; it gets a default one"});
    CHECK(r.scene->whitted().materials[0].diffuse == Color(0.5F));
}

TEST_CASE("an NFF cone may stand on one line or on three") {
    for (const std::string text : {"c 1 2 3 0.5 4 5 6 0.25", "c\n1 2 3 0.5\n4 5 6 0.25"}) {
        const LoadResult r = load_nff_text(matt + text);
        CHECK(messages(r).empty());
        REQUIRE(r.scene->geometry.all<Cone>().size() == 1);
        const Cone& c = r.scene->geometry.all<Cone>()[0];
        CHECK(c.base == Vec3(1, 2, 3));
        CHECK(c.base_radius == 0.5);
        CHECK(c.top == Vec3(4, 5, 6));
        CHECK(c.top_radius == 0.25);
    }
}

TEST_CASE("an NFF polygon may have hundreds of corners and be concave") {
    const LoadResult r = load_nff_text(matt + star(72) + star(1000));
    CHECK(messages(r).empty());
    REQUIRE(r.scene->geometry.all<Polygon>().size() == 2);
    CHECK(r.scene->geometry.all<Polygon>()[0].corners.size() == 144);
    CHECK(r.scene->geometry.all<Polygon>()[1].corners.size() == 2000);
}

TEST_CASE("an NFF patch has a normal at each corner") {
    const LoadResult r =
        load_nff_text(matt + "pp 3\n0 0 0 0 0 2\n1 0 0 0 1 0\n0 1 0 1 0 0\ns 0 0 0 1");
    CHECK(messages(r).empty());
    REQUIRE(r.scene->geometry.all<Triangle>().size() == 1);
    CHECK(std::ranges::equal(corner_normals(*r.scene, 0), r.scene->geometry.normals));
    CHECK(r.scene->geometry.normals ==
          LargeVector<Vec3>{Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(1, 0, 0)});
}

TEST_CASE("an NFF shape is seen from both sides, by a negative radius from its inside") {
    const LoadResult r = load_nff_text(matt + "s 0 0 0 1\ns 0 0 0 -1\nc 0 0 0 -1 0 0 1 0");
    CHECK(messages(r).empty());
    CHECK(r.scene->geometry.primitives[0].sides == Sides::both);
    CHECK(r.scene->geometry.primitives[1].sides == Sides::back);
    CHECK(r.scene->geometry.primitives[2].sides == Sides::back);
    CHECK(r.scene->geometry.all<Sphere>()[1].radius == 1);
}

TEST_CASE("one-sided hides the back of opaque NFF shapes only") {
    const LoadResult r = load_nff_text(
        matt + "s 0 0 0 1\np 3 0 0 0 1 0 0 0 1 0\ns 0 0 0 -1\n" + glass + "s 0 0 0 1", one_sided());
    CHECK(messages(r).empty());
    CHECK(r.scene->geometry.primitives[0].sides == Sides::front);
    CHECK(r.scene->geometry.primitives[1].sides == Sides::front);
    CHECK(r.scene->geometry.primitives[2].sides == Sides::back);
    CHECK(r.scene->geometry.primitives[3].sides == Sides::both);
}
