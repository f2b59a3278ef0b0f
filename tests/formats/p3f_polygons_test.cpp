// p and pp.
#include "tests/catch.h"
#include "tests/formats/corners.h"
#include "tests/formats/p3f_text.h"

using namespace etalon;

TEST_CASE("a polygon of three corners is a triangle") {
    const LoadResult r = load_objects("p 3\n0 0 0\n1 0 0\n0 1 0");
    CHECK(messages(r).empty());
    REQUIRE(r.scene->geometry.all<Triangle>().size() == 1);
    CHECK(corners_of(*r.scene, 0) == std::vector{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
    CHECK(corner_normals(*r.scene, 0).empty());
    CHECK(r.scene->geometry.primitives[0].sides == Sides::both);
}

TEST_CASE("a polygon of more corners, concave too, is one shape") {
    const LoadResult r = load_objects("p 3 9 9 9 8 9 9 9 8 9\np 4 0 0 0 2 2 0 0 1 0 -2 2 0");
    CHECK(messages(r).empty());
    REQUIRE(r.scene->geometry.all<Polygon>().size() == 1);
    const Polygon polygon = r.scene->geometry.all<Polygon>()[0];
    CHECK(std::ranges::equal(
        polygon.corners, std::vector{Vec3(0, 0, 0), Vec3(2, 2, 0), Vec3(0, 1, 0), Vec3(-2, 2, 0)}));
    CHECK(polygon.normals.empty());
    CHECK(vertex_count(*r.scene) == 3);
    CHECK(r.scene->geometry.primitives[1].kind == kind_of<Polygon>());
}

TEST_CASE("a patch has a normal at each corner, of unit length") {
    const LoadResult r = load_objects(
        "pp 3 0 0 0 0 0 2 1 0 0 0 3 4 0 1 0 0 0 1\n"
        "pp 4 0 0 0 0 0 1 1 0 0 0 0 1 1 1 0 0 0 1 0 1 0 1e-200 0 0");
    CHECK(messages(r).empty());
    CHECK(corner_normals(*r.scene, 0)[0] == r.scene->geometry.normals[0]);
    REQUIRE(r.scene->geometry.normals.size() == 3);
    CHECK(r.scene->geometry.normals[0] == Vec3(0, 0, 1));
    CHECK(r.scene->geometry.normals[1].y == Approx(0.6));
    CHECK(r.scene->geometry.normals[1].z == Approx(0.8));
    const Polygon polygon = r.scene->geometry.all<Polygon>()[0];
    CHECK(std::ranges::equal(
        polygon.normals, std::vector{Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(1, 0, 0)}));
}

TEST_CASE("a patch with a zero normal is shaded flat") {
    const LoadResult r = load_objects("pp 3 0 0 0 0 0 1 1 0 0 0 0 0 0 1 0 0 0 1");
    CHECK(messages(r) == Messages{"a.p3f:2:1: warning: 'pp' shaded flat: a corner normal is zero"});
    CHECK(corner_normals(*r.scene, 0).empty());
    CHECK(r.scene->geometry.normals.empty());
}

TEST_CASE("a polygon of too few corners is left out") {
    const LoadResult r = load_objects("p 2 0 0 0 1 0 0\np 0\ns 0 0 0 1");
    CHECK(messages(r) ==
          Messages{"a.p3f:2:3: warning: 'p' left out: 2 corners, expected at least 3",
                   "a.p3f:3:3: warning: 'p' left out: 0 corners, expected at least 3"});
    CHECK(r.scene->geometry.vertices.empty());
    CHECK(r.scene->geometry.primitives.size() == 1);
}

TEST_CASE("a polygon without area is left out") {
    const LoadResult r =
        load_objects("p 3 0 0 0 1 1 1 2 2 2\np 4 1 1 1 1 1 1 1 1 1 1 1 1\ns 0 0 0 1");
    CHECK(messages(r) == Messages{"a.p3f:2:1: warning: 'p' left out: it has no area",
                                  "a.p3f:3:1: warning: 'p' left out: it has no area"});
    CHECK(r.scene->geometry.vertices.empty());
}

TEST_CASE("a tiny and a huge polygon have an area") {
    CHECK(load_objects("p 3 0 0 0 1e-200 0 0 0 1e-200 0").diagnostics.empty());
    CHECK(load_objects("p 3 0 0 0 1e200 0 0 0 1e200 0").diagnostics.empty());
}

TEST_CASE("a polygon that breaks off leaves nothing behind") {
    const LoadResult r = load_objects("pp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1\ns 0 0 0 1");
    CHECK(messages(r) ==
          Messages{"a.p3f:3:1: warning: expected a number for the corner of 'pp', found 's'"});
    CHECK(r.scene->geometry.vertices.empty());
    CHECK(r.scene->geometry.normals.empty());
    CHECK(r.scene->geometry.primitives.size() == 1);
}

TEST_CASE("a polygon that announces more corners than the file can hold is left out at once") {
    const LoadResult r =
        load_p3f_text(good_camera + good_material + "p 1000000000\n0 0 0 1 0 0 0 1 0\ns 0 0 0 1");
    CHECK(messages(r) ==
          Messages{"a.p3f:11:3: warning: the number of corners of 'p' is 1000000000, but the "
                   "rest of the file holds at most 4"});
    CHECK(r.scene->geometry.vertices.capacity() == 0);
    CHECK(r.scene->geometry.primitives.size() == 1);
    CHECK(messages(load_objects("p -3 0 0 0")) ==
          Messages{"a.p3f:2:3: warning: the number of corners of 'p' is negative"});
}

TEST_CASE("corners of patches that agree in position and normal are one vertex") {
    const std::string a = "0 0 0 0 0 1 ", b = "1 0 0 0 0 1 ", c = "0 1 0 0 0 1 ",
                      d = "1 1 0 0 0 1 ";
    const LoadResult r = load_objects("pp 3 " + a + b + c + "\npp 3 " + b + d + c);
    CHECK(vertex_count(*r.scene) == 4);
    CHECK(corners_of(*r.scene, 1) == std::vector{Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)});
    const LoadResult other = load_objects("pp 3 " + a + b + c + "\npp 3 " + b + d + "0 1 0 0 1 1");
    CHECK(vertex_count(*other.scene) == 5);
    CHECK(corner_normals(*other.scene, 0)[2] == Vec3(0, 0, 1));
    CHECK(corner_normals(*other.scene, 1)[2].y > 0.7);
}
