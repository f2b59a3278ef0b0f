// Matrix, surface, and the blocks that save them.
#include <variant>

#include "tests/catch.h"
#include "tests/formats/corners.h"
#include "tests/formats/sce_text.h"

using namespace etalon;

namespace {

/// Positions of (1, 0, 0), (0, 1, 0) and the origin after these lines.
std::vector<Vec3> moved(const std::string& lines, const LoadOptions& options = {}) {
    const LoadResult r = load_sce_text(
        lines + "\npointlight 1 0 0 1 1 1\npointlight 0 1 0 1 1 1\npointlight 0 0 0 1 1 1\n",
        options);
    CAPTURE(lines, messages(r));
    REQUIRE(r.scene);
    std::vector<Vec3> places;
    for (const Light& light : r.scene->whitted().lights) {
        places.push_back(std::get<PointLight>(light).position);
    }
    REQUIRE(places.size() == 3);
    return places;
}

Messages said(const std::string& lines) {
    return messages(load_sce_text(lines));
}

}  // namespace

TEST_CASE("the command nearest a shape acts on it first") {
    CHECK(moved("translate 5 0 0\nscale 2 3 4") ==
          std::vector{Vec3(7, 0, 0), Vec3(5, 3, 0), Vec3(5, 0, 0)});
    CHECK(moved("scale 2 3 4\ntranslate 5 0 0") ==
          std::vector{Vec3(12, 0, 0), Vec3(10, 3, 0), Vec3(10, 0, 0)});
}

TEST_CASE("a rotation is right-handed, in degrees, about an axis of any length") {
    CHECK(moved("rotate 90 0 0 3")[0] == Vec3(0, 1, 0));
    CHECK(moved("rotate 90 1 0 0")[1] == Vec3(0, 0, 1));
    CHECK(moved("rotate -90 0 1 0")[0] == Vec3(0, 0, 1));
    CHECK(said("rotate 90 0 0 0") ==
          Messages{"a.sce:1:1: warning: 'rotate' left out: its axis is zero"});
}

TEST_CASE("the legacy rotation has the course's sign error where its axis has an x") {
    LoadOptions legacy;
    legacy.legacy = true;
    const std::string x_from_z = "\nrotate -90 0 1 0";
    CHECK(moved("rotate 90 1 0 0" + x_from_z, legacy)[0] == Vec3(0, 1, 0));
    CHECK(moved("rotate 90 1 0 0" + x_from_z)[0] == Vec3(0, -1, 0));
    CHECK(moved("rotate 90 1 0 0", legacy)[1] == Vec3(0, 0, 1));
    for (const std::string right : {"rotate 33 0 0 1", "rotate 25 0 1 0.3"}) {
        CHECK(moved(right, legacy) == moved(right));
    }
    const LoadResult r = load_sce_text("rotate 45 1 0 0\n" + unit_triangle, legacy);
    CHECK(messages(r) ==
          Messages{"a.sce:2:1: warning: 'triangle' left out: its matrix is singular"});
}

TEST_CASE("braces save matrix and surface, push_matrix the matrix alone") {
    const LoadResult r = load_sce_text(
        "cr 1 0 0\n{\ntranslate 1 0 0\ncr 0 1 0\n" + unit_triangle + "}\n" + unit_triangle +
        "push_matrix\ntranslate 0 5 0\ncr 0 0 1\npop_matrix\n" + unit_triangle);
    CHECK(messages(r).empty());
    const Scene& s = *r.scene;
    REQUIRE(s.geometry.primitives.size() == 3);
    const auto diffuse = [&](std::size_t i) {
        return s.whitted().materials[s.geometry.primitives[i].material].diffuse;
    };
    CHECK(corners_of(s, 0)[0] == Vec3(1, 0, 0));
    CHECK(diffuse(0) == Color(0, 1, 0));
    CHECK(corners_of(s, 1)[0] == Vec3(0));
    CHECK(diffuse(1) == Color(1, 0, 0));
    CHECK(corners_of(s, 2)[0] == Vec3(0));
    CHECK(diffuse(2) == Color(0, 0, 1));
}

TEST_CASE("shapes of one surface share a material") {
    const LoadResult r =
        load_sce_text("cr 1 0 0\n" + unit_triangle + unit_triangle + "{\ntranslate 1 0 0\n" +
                      unit_triangle + "}\n" + unit_triangle + "shininess 2\n" + unit_triangle);
    CHECK(r.scene->whitted().materials.size() == 2);
    CHECK(r.scene->geometry.primitives[3].material == 0);
    CHECK(r.scene->geometry.primitives[4].material == 1);
}

TEST_CASE("an unmatched closing command is reported and left out") {
    CHECK(said("nx 8\n  }\n") ==
          Messages{"a.sce:2:3: warning: '}' without a '{' before it; left out"});
    CHECK(said("pop_matrix\n") ==
          Messages{"a.sce:1:1: warning: 'pop_matrix' without a 'push_matrix' before it; left out"});
    CHECK(moved("scale 2 2 2\npop_matrix\n}")[0] == Vec3(2, 0, 0));
}

TEST_CASE("blocks of both kinds must not cross") {
    const Messages crossing = {
        "a.sce:4:1: warning: '}' inside a 'push_matrix' that is still open; left out"};
    const std::string lines = "{\npush_matrix\nscale 2 2 2\n}\n";
    CHECK(said(lines + "pop_matrix\n}\n") == crossing);
    CHECK(moved(lines + "pop_matrix\n}")[0] == Vec3(1, 0, 0));
    CHECK(moved(lines + "pop_matrix\nscale 3 3 3")[0] == Vec3(3, 0, 0));
    CHECK(said("push_matrix\n{\npop_matrix\n}\npop_matrix") ==
          Messages{"a.sce:3:1: warning: 'pop_matrix' inside a '{' that is still open; left out"});
}

TEST_CASE("a block that is never closed is reported where it opens") {
    CHECK(said("{\n{\n}\n push_matrix\n") ==
          Messages{"a.sce:1:1: warning: '{' is never closed",
                   "a.sce:4:2: warning: 'push_matrix' is never closed"});
}

TEST_CASE("a surface is a material with the ambient light of its own") {
    const LoadResult r =
        load_sce_text("ca .5 .25 1\ncr .5 1 .25\ncp .125 .25 .5\nshininess 30\n" + unit_triangle);
    const Material& m = r.scene->whitted().materials[0];
    CHECK(m.ambient == Color(0.25F, 0.25F, 0.25F));
    CHECK(m.diffuse == Color(0.5F, 1, 0.25F));
    CHECK(m.specular == Color(0.125F, 0.25F, 0.5F));
    CHECK(m.reflection == m.specular);
    CHECK(m.shininess == 30);
    CHECK(m.highlight == Highlight::blinn);
    CHECK(m.transmission == Color(0.0F));
    const Material plain = load_sce_text(unit_triangle).scene->whitted().materials[0];
    CHECK(plain.ambient == Color(0.1F));
    CHECK(plain.diffuse == Color(1.0F));
    CHECK(plain.specular == Color(0.0F));
    CHECK(plain.shininess == 1);
}

TEST_CASE("an impossible surface is left out") {
    CHECK(said("shininess -1\n") ==
          Messages{"a.sce:1:1: warning: the shininess is -1; expected 0 or more"});
    CHECK(said("ca 1e30 0 0\ncr 1e30 0 0\n") ==
          Messages{"a.sce:2:1: warning: 'ca' times 'cr' is too large for a colour"});
}
