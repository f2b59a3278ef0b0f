// Height fields and NURBS converted to triangles.
#include "core/formats/load.h"
#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;

namespace {

LoadResult loaded(const std::string& shape) {
    LoadResult r = load_scene_text("WorldBegin\n" + shape + "\nWorldEnd\n", "a.pbrt", {});
    REQUIRE(r.scene);
    return r;
}

/// Returns the message about a shape that is left out.
std::string said_of(const std::string& shape) {
    const LoadResult r = loaded(shape);
    REQUIRE(r.diagnostics.size() == 1);
    CHECK(r.scene->geometry.primitives.size() == 0);
    return to_string(r.diagnostics[0]);
}

const std::string cylinder =
    "Shape \"nurbs\" \"integer nu\" 3 \"integer nv\" 2 \"integer uorder\" 3 \"integer vorder\" 2 "
    "\"float uknots\" [0 0 0 1 1 1] \"float vknots\" [0 0 1 1] ";

const std::string points = "\"point P\" [0 0 0  1 0 0  2 0 0  0 1 0  1 1 0  2 1 0] ";

}  // namespace

TEST_CASE("a height field is a mesh over the unit square, with the square's coordinates") {
    const LoadResult r = loaded(
        "Scale 1 1 2 Shape \"heightfield\" \"integer nu\" 3 \"integer nv\" 2 "
        "\"float Pz\" [0 1 2 3 4 5]");
    CHECK(r.diagnostics.empty());
    const Geometry& g = r.scene->geometry;
    REQUIRE(g.vertices.size() == 6);
    CHECK(g.all<Triangle>().size() == 4);
    CHECK(g.vertices[1] == Vec3(0.5, 0, 2));
    CHECK(g.vertices[5] == Vec3(1, 1, 10));
    CHECK(r.scene->geometry.uvs[4] == std::array{0.5F, 1.0F});
    CHECK(g.all<Triangle>()[1] == TriangleIndices{0, 4, 3});
    CHECK_FALSE(r.scene->physical().bindings[0].flipped);
}

TEST_CASE("a height field whose heights are no grid is left out") {
    CHECK(
        said_of("Shape \"heightfield\" \"integer nu\" 3 \"integer nv\" 2 \"float Pz\" [0 1 2 3]") ==
        "a.pbrt:2:1: warning: \"heightfield\" left out: 3 x 2 heights are 6, not 4");
    CHECK(said_of("Shape \"heightfield\" \"integer nu\" 1 \"integer nv\" 2 \"float Pz\" [0 1]") ==
          "a.pbrt:2:1: warning: \"heightfield\" left out: it has no area");
    CHECK(
        said_of("Shape \"heightfield\" \"integer nu\" -3 \"integer nv\" -2 \"float Pz\" [0 1 2 3 4 "
                "5]") == "a.pbrt:2:1: warning: \"heightfield\" left out: it has no area");
}

TEST_CASE("a NURBS surface is a mesh of 30 x 30 points with normals and coordinates") {
    const LoadResult r = loaded(cylinder + points);
    CHECK(r.diagnostics.empty());
    const Geometry& g = r.scene->geometry;
    REQUIRE(g.vertices.size() == 900);
    CHECK(g.all<Triangle>().size() == 2 * 29 * 29);
    CHECK(g.vertices[899] == Vec3(2, 1, 0));
    CHECK(g.normals[450] == Vec3(0, 0, 1));
    CHECK(r.scene->geometry.uvs[29] == std::array{1.0F, 0.0F});
    CHECK(r.scene->physical().bindings[0].corner_normals);
}

TEST_CASE("control points of NURBS may have weights") {
    const LoadResult weighted =
        loaded(cylinder + "\"float Pw\" [0 0 0 1  2 0 0 2  2 0 0 1  0 1 0 1  2 2 0 2  2 1 0 1]");
    const LoadResult plain = loaded(cylinder + points);
    CHECK(weighted.scene->geometry.vertices[899] == Vec3(2, 1, 0));
    // The weight of 2 attracts the surface to the middle: at u = 10/29 x is further from the
    // border.
    CHECK(weighted.scene->geometry.vertices[10].x > plain.scene->geometry.vertices[10].x + 0.05);
}

TEST_CASE("a NURBS surface whose parameters do not go together is left out") {
    const std::string head = "a.pbrt:2:1: warning: \"nurbs\" left out: ";
    CHECK(said_of(cylinder) == head + "3 x 2 control points are 6, not 0");
    CHECK(said_of(cylinder + points + "\"float u1\" 2") ==
          head + "along u: its part from 0 to 2 is not within 0 to 1");
    std::string high = cylinder + points;
    const std::string order = "\"integer vorder\" ";
    high.replace(high.find(order) + order.size(), 1, "4");
    CHECK(said_of(high) == head + "along v: a spline of order 4 has 4 points or more, not 2");
    CHECK(
        said_of(cylinder + "\"float Pw\" [0 0 0 1  2 0 0 2  2 0 0 1  0 1 0 0  2 2 0 0  2 1 0 0]") ==
        head + "its weights or points are out of range");
}
