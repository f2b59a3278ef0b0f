// surface, sphere, hsphere, cone, polygon, ring, quadric.
#include "tests/catch.h"
#include "tests/formats/prt_text.h"

using namespace etalon;

namespace {

Material material_of(const std::string& statement) {
    const LoadResult r = load_prt_text(statement);
    CAPTURE(statement);
    CHECK(messages(r).empty());
    REQUIRE(r.scene->whitted().materials.size() == 1);
    return r.scene->whitted().materials[0];
}

/// Returns the message about an object in line 7, which is left out.
std::string warning_of(const std::string& text) {
    const LoadResult r = load_prt_text(red + text);
    CAPTURE(text);
    REQUIRE(r.diagnostics.size() == 1);
    CHECK(r.diagnostics[0].line == 7);
    CHECK(r.scene->geometry.primitives.empty());
    return r.diagnostics[0].message;
}

Primitive only_primitive(const LoadResult& r) {
    CHECK(messages(r).empty());
    REQUIRE(r.scene->geometry.primitives.size() == 1);
    return r.scene->geometry.primitives[0];
}

}  // namespace

TEST_CASE("a PRT surface is nineteen numbers") {
    const Material m =
        material_of("surface 1 .5 .25 .5  .25 .5 1 .75  .1 .2 .3  .4 .5 .6  .7 .8 .9 30.5 1.25");
    CHECK(m.reflection == Color(0.5F, 0.25F, 0.125F));
    CHECK(m.transmission == Color(0.1875F, 0.375F, 0.75F));
    CHECK(m.ambient == Color(0.1F, 0.2F, 0.3F));
    CHECK(m.diffuse == Color(0.4F, 0.5F, 0.6F));
    CHECK(m.specular == Color(0.7F, 0.8F, 0.9F));
    CHECK(m.shininess == 30.5);
    CHECK(m.highlight == Highlight::phong);
    CHECK(m.ior == 1.25);
    CHECK_FALSE(m.fresnel);
    CHECK(m.absorption == Color(0.0F));
}

TEST_CASE("a PRT surface without an exponent has no highlight, an opaque one any index") {
    CHECK(material_of("surface 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 1 1 0 0").specular == Color(0.0F));
    CHECK(material_of("surface 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 1 1 1 0").specular == Color(1.0F));
    CHECK(material_of("surface 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 1 1 1 -3").ior == 1);
    CHECK(messages(load_prt_text("surface 0 0 0 0 1 1 1 1 0 0 0 0 0 0 0 0 0 0 0")) ==
          Messages{"a.prt:6:1: warning: the index of refraction of glass is 0; expected more than "
                   "0"});
}

TEST_CASE("a PRT object before any surface gets a grey one, with a warning") {
    const LoadResult r = load_prt_text("sphere 0 0 0 1\n");
    CHECK(messages(r) ==
          Messages{"a.prt:6:1: warning: 'sphere' before any material; it gets a default one"});
    CHECK(r.scene->whitted().materials[0].diffuse == Color(0.5F));
}

TEST_CASE("PRT spheres, cones and polygons are read") {
    const LoadResult r = load_prt_text(
        red +
        "sphere 1 2 3 .5\ncone\n1 2 3 .5\n4 5 6 .25\npolygon 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" +
        "polygon 3 0 0 0 1 0 0 0 1 0");
    CHECK(messages(r).empty());
    CHECK(r.scene->geometry.all<Sphere>()[0].centre == Vec3(1, 2, 3));
    CHECK(r.scene->geometry.all<Cone>()[0].base_radius == 0.5);
    CHECK(r.scene->geometry.all<Cone>()[0].top == Vec3(4, 5, 6));
    CHECK(r.scene->geometry.all<Cone>()[0].top_radius == 0.25);
    CHECK(r.scene->geometry.all<Polygon>()[0].corners.size() == 4);
    CHECK(r.scene->geometry.all<Triangle>().size() == 1);
    CHECK(warning_of("polygon 2 0 0 0 1 0 0") ==
          "'polygon' left out: 2 corners, expected at least 3");
}

TEST_CASE("a sphere of five numbers is a sphere") {
    const LoadResult r = load_prt_text(red + "sphere 1 2 3 .5 .1\nsphere 0 0 0 1");
    CHECK(messages(r) ==
          Messages{"a.prt:7:17: warning: expected a keyword after 'sphere', found '.1'"});
    CHECK(r.scene->geometry.all<Sphere>().size() == 2);
}

TEST_CASE("an hsphere is a sphere of matter about one of nothing") {
    const LoadResult r = load_prt_text(glass + "hsphere 1 2 3 .5 .125\nsphere 0 0 0 1");
    CHECK(messages(r).empty());
    REQUIRE(r.scene->geometry.all<Sphere>().size() == 3);
    const Sphere &outer = r.scene->geometry.all<Sphere>()[0],
                 &inner = r.scene->geometry.all<Sphere>()[1];
    CHECK(outer.centre == Vec3(1, 2, 3));
    CHECK(outer.radius == 0.5);
    CHECK(inner.centre == Vec3(1, 2, 3));
    CHECK(inner.radius == 0.375);
    const auto material = [&](int i) {
        return r.scene->whitted().materials[r.scene->geometry.primitives[i].material];
    };
    CHECK(material(0).ior == 1.5);
    CHECK(material(1).ior == 1 / 1.5);
    CHECK(material(1).transmission == material(0).transmission);
    CHECK(material(2).ior == 1.5);  // the hollow sphere has its own
}

TEST_CASE("an hsphere as thick as its radius is a sphere") {
    CHECK(only_primitive(load_prt_text(glass + "hsphere 1 2 3 .5 .5")).kind == kind_of<Sphere>());
}

TEST_CASE("an hsphere that cannot be is left out") {
    const std::string thickness =
        "'hsphere' left out: its thickness is not more than 0 and at most its radius";
    CHECK(warning_of("hsphere 1 2 3 .5 0") == thickness);
    CHECK(warning_of("hsphere 1 2 3 .5 -.1") == thickness);
    CHECK(warning_of("hsphere 1 2 3 .5 .6") == thickness);
    CHECK(warning_of("hsphere 1 2 3 -1 .5") == "'hsphere' left out: its radius is not more than 0");
}

TEST_CASE("a ring has its outer radius first, then its inner one") {
    const LoadResult r = load_prt_text(red + "ring 1 2 3  2 2 3  1 4 3  5 4");
    only_primitive(r);
    REQUIRE(r.scene->geometry.all<Ring>().size() == 1);
    const Ring& ring = r.scene->geometry.all<Ring>()[0];
    CHECK(ring.centre == Vec3(1, 2, 3));
    CHECK(ring.outer == 5);
    CHECK(ring.inner == 4);
    CHECK(ring.normal.x == 0);
    CHECK(ring.normal.y == 0);
    CHECK(ring.normal.z > 0);
}

TEST_CASE("a ring that cannot be is left out") {
    CHECK(warning_of("ring 0 0 0 1 0 0 0 1 0 1 2") ==
          "'ring' left out: its inner radius, the second, is not between 0 and the outer one");
    CHECK(warning_of("ring 0 0 0 1 0 0 0 1 0 1 -1") ==
          "'ring' left out: its inner radius, the second, is not between 0 and the outer one");
    CHECK(warning_of("ring 0 0 0 1 0 0 0 1 0 0 0") ==
          "'ring' left out: its outer radius is not more than 0");
    CHECK(warning_of("ring 0 0 0 1 0 0 2 0 0 2 1") == "'ring' left out: its points span no plane");
}

TEST_CASE("a quadric has its ten coefficients row by row, in a box of the world") {
    const LoadResult r =
        load_prt_text(red + "quadric 1 2 3\n-4 -5 -6 4 5 6\n1 2 3 4 5\n6 7 8 9 10");
    only_primitive(r);
    REQUIRE(r.scene->geometry.all<Quadric>().size() == 1);
    const Quadric& q = r.scene->geometry.all<Quadric>()[0];
    CHECK(q.centre == Vec3(1, 2, 3));
    CHECK(q.coefficients == std::array<double, 10>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    CHECK(q.clip.min == Vec3(-4, -5, -6));
    CHECK(q.clip.max == Vec3(4, 5, 6));
}

TEST_CASE("a quadric of no extent is left out, one in an upturned box put right") {
    CHECK(warning_of("quadric 0 0 0 -1 -1 -1 1 1 1 0 0 0 0 0 0 0 0 0 7") ==
          "'quadric' left out: its coefficients are all 0");
    const LoadResult r = load_prt_text(red + "quadric 0 0 0 1 -1 1 -1 1 -1 1 0 0 0 1 0 0 1 0 -1");
    CHECK(messages(r) == Messages{"a.prt:7:1: warning: the corners of the box are not the lower "
                                  "and the upper one; exchanged"});
    CHECK(r.scene->geometry.all<Quadric>()[0].clip.min == Vec3(-1));
    CHECK(r.scene->geometry.all<Quadric>()[0].clip.max == Vec3(1));
}

TEST_CASE("legacy PRT forgets the centre of a quadric, but not where its box is") {
    LoadOptions legacy;
    legacy.legacy = true;
    const std::string quadric = "quadric 1 2 3\n-4 -5 -6 4 5 6\n1 0 0 0 1\n0 0 1 0 -1\n";
    const LoadResult r = load_prt_text(red + quadric, legacy);
    only_primitive(r);
    CHECK(r.scene->geometry.all<Quadric>()[0].centre == Vec3(0));
    CHECK(r.scene->geometry.all<Quadric>()[0].clip.min == Vec3(-4, -5, -6));
}

TEST_CASE("one-sided hides the back of opaque PRT shapes, and the shell about an opaque hollow") {
    LoadOptions options;
    options.one_sided = true;
    const LoadResult r = load_prt_text(
        red + "ring 0 0 0 1 0 0 0 1 0 2 1\nhsphere 0 0 0 1 .5\n" + glass + "hsphere 0 0 0 1 .5",
        options);
    CHECK(r.scene->geometry.primitives[0].sides == Sides::front);
    CHECK(r.scene->geometry.primitives[1].sides == Sides::front);
    CHECK(r.scene->geometry.primitives[2].sides == Sides::back);
    CHECK(r.scene->geometry.primitives[3].sides == Sides::both);
    CHECK(r.scene->geometry.primitives[4].sides == Sides::both);
}
