#include "tests/catch.h"
#include "tests/formats/p3f_text.h"

using namespace etalon;

namespace {

Material material_of(const std::string& statement, const LoadOptions& options = {}) {
    const LoadResult r = load_statements(statement, options);
    CAPTURE(statement);
    CHECK(messages(r).empty());
    REQUIRE(r.scene->whitted().materials.size() == 1);
    return r.scene->whitted().materials[0];
}

}  // namespace

TEST_CASE("a matt material has weighted colours and sends no rays on") {
    for (const std::string keyword : {"mat", "f"}) {
        const Material m = material_of(keyword + " 1 0.5 0.25 0.5 1 1 0.5 0 10 0 1");
        CHECK(m.diffuse == Color(0.5F, 0.25F, 0.125F));
        CHECK(m.specular == Color(0.0F));
        CHECK(m.shininess == 10);
        CHECK(m.reflection == Color(0.0F));
        CHECK(m.transmission == Color(0.0F));
        CHECK(m.absorption == Color(0.0F));
        CHECK_FALSE(m.fresnel);
    }
}

TEST_CASE("an opaque material with Ks mirrors by its weighted specular colour") {
    const Material m = material_of("mat 1 1 1 0 1 0.5 0.25 0.5 30 0 1");
    CHECK(m.specular == Color(0.5F, 0.25F, 0.125F));
    CHECK(m.reflection == Color(0.5F, 0.25F, 0.125F));
    CHECK_FALSE(m.fresnel);
}

TEST_CASE("a material with T is a dielectric that absorbs by what its diffuse colour lacks") {
    const Material m = material_of("mat 0 0.25 2 0.5 1 0.5 0.25 0.5 30 1 1.5");
    CHECK(m.diffuse == Color(0, 0.125F, 1));
    CHECK(m.specular == Color(0.5F, 0.25F, 0.125F));
    CHECK(m.reflection == Color(1, 0.5F, 0.25F));
    CHECK(m.transmission == Color(1.0F));
    CHECK(m.fresnel);
    CHECK(m.ior == 1.5);
    CHECK(m.absorption == Color(1, 0.75F, 0));
    CHECK(material_of("mat 1 1 1 0 1 1 1 0 1 0.25 1.5").fresnel);
}

TEST_CASE("glass of the old dialect does not absorb") {
    const Material m = material_of("f 0 0.25 1 0.5 1 0.5 0.25 0.5 30 1 1.5");
    CHECK(m.fresnel);
    CHECK(m.absorption == Color(0.0F));
}

TEST_CASE("a material holds for the objects after it") {
    const LoadResult r = load_statements(
        "mat 1 0 0 1 1 1 1 0 1 0 1\ns 0 0 0 1\nf 0 1 0 1 1 1 1 0 1 0 1\ns 1 0 0 1\nbox 0 0 0 1 1 "
        "1");
    REQUIRE(r.scene->geometry.primitives.size() == 3);
    CHECK(r.scene->geometry.primitives[0].material == 0);
    CHECK(r.scene->geometry.primitives[1].material == 1);
    CHECK(r.scene->geometry.primitives[2].material == 1);
}

TEST_CASE("objects before any material get the default one, with one warning") {
    const LoadResult r = load_statements("s 0 0 0 1\ns 1 0 0 1\n" + good_material + "s 2 0 0 1");
    CHECK(messages(r) ==
          Messages{"a.p3f:1:1: warning: 's' before any material; it gets a default one"});
    REQUIRE(r.scene->whitted().materials.size() == 2);
    CHECK(r.scene->geometry.primitives[0].material == 0);
    CHECK(r.scene->geometry.primitives[1].material == 0);
    CHECK(r.scene->geometry.primitives[2].material == 1);
    const Material& m = r.scene->whitted().materials[0];
    CHECK(m.diffuse == Color(0.2F * 0.2F));
    CHECK(m.specular == Color(0.8F));
    CHECK(m.reflection == Color(0.8F));
    CHECK(m.shininess == 20);
    CHECK_FALSE(m.fresnel);
}

TEST_CASE("the 12- and 14-number materials of single programs are read as far as they are P3F") {
    const std::string eleven = "1 1 1 0.5 1 1 1 0 10 0 1";
    const auto warning = [](const std::string& place, const std::string& keyword,
                            const std::string& what) {
        return Messages{"a.p3f:1:" + place + ": warning: a '" + keyword + "' of " + what +
                        " is a private extension of one program; the first 11 are used"};
    };
    const LoadResult rough = load_statements("mat " + eleven + " 0.3\ns 0 0 0 1");
    CHECK(messages(rough) == warning("30", "mat", "12 numbers (roughness)"));
    CHECK(rough.scene->whitted().materials[0].diffuse == Color(0.5F));
    CHECK(rough.scene->geometry.primitives.size() == 1);
    const LoadResult glow = load_statements("f " + eleven + " 1 0 0\ns 0 0 0 1");
    CHECK(messages(glow) == warning("28", "f", "14 numbers (emission)"));
    CHECK(glow.scene->geometry.primitives.size() == 1);
}

TEST_CASE("any other number of numbers too many is told") {
    const LoadResult r = load_statements("f 1 1 1 0.5 1 1 1 0 10 0 1 7 7\ns 0 0 0 1");
    CHECK(messages(r) == Messages{"a.p3f:1:28: warning: expected 11 numbers after 'f', found 13"});
    CHECK(r.scene->whitted().materials.size() == 1);
}

TEST_CASE("a material that cannot be is left out") {
    const auto kept = [](const std::string& numbers) {
        const LoadResult r = load_statements(good_material + "mat " + numbers + "\ns 0 0 0 1");
        REQUIRE(r.diagnostics.size() == 1);
        CHECK(r.diagnostics[0].line == 2);
        CHECK(r.scene->whitted().materials.size() == 1);
        return r.diagnostics[0].message;
    };
    CHECK(kept("1 1 1 1 1 1 1 1 10 1 0") ==
          "the index of refraction of glass is 0; expected more than 0");
    CHECK(kept("1 1 1 1 1 1 1 1 -1 0 1") == "the Shine is -1; expected 0 or more");
    CHECK(kept("1e30 1 1 1e30 1 1 1 1 1 0 1") ==
          "a colour times its weight is too large for a colour");
    CHECK(kept("1 1 1 1 1 1 x") == "expected a number for the specular colour of 'mat', found 'x'");
    CHECK(load_statements("f 1 1 1 1 1 1 1 0 10 0 0").diagnostics.empty());
}
