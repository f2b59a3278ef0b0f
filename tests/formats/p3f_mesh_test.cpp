#include "tests/catch.h"
#include "tests/formats/corners.h"
#include "tests/formats/p3f_text.h"

using namespace etalon;

namespace {

const std::string square = "\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";  // lines 3 to 6 of load_objects

const std::array corner = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};

}  // namespace

TEST_CASE("a mesh is triangles of shared vertices, numbered from 1") {
    const LoadResult r = load_objects("mesh 4 2" + square + "1 2 3\n1 3 4");
    CHECK(messages(r).empty());
    CHECK(vertex_count(*r.scene) == 4);
    REQUIRE(r.scene->geometry.all<Triangle>().size() == 2);
    CHECK(corners_of(*r.scene, 0) == std::vector{corner[0], corner[1], corner[2]});
    CHECK(corners_of(*r.scene, 1) == std::vector{corner[0], corner[2], corner[3]});
    CHECK(corner_normals(*r.scene, 1).empty());
    CHECK(r.scene->geometry.primitives.size() == 2);
}

TEST_CASE("negative numbers count a mesh's vertices from the end, each for itself") {
    const LoadResult r = load_objects("mesh 4 2" + square + "-4 2 -2\n1 -2 -1");
    CHECK(messages(r).empty());
    CHECK(corners_of(*r.scene, 0) == std::vector{corner[0], corner[1], corner[2]});
    CHECK(corners_of(*r.scene, 1) == std::vector{corner[0], corner[2], corner[3]});
}

TEST_CASE("the vertices of a second mesh are its own") {
    const LoadResult r = load_objects("mesh 4 1" + square + "1 2 3\nmesh 4 1" + square + "1 2 -1");
    CHECK(messages(r).empty());
    CHECK(vertex_count(*r.scene) == 8);
    CHECK(corners_of(*r.scene, 1) == std::vector{corner[0], corner[1], corner[3]});
}

TEST_CASE("a face with a missing vertex is left out, and each wrong index is reported") {
    const LoadResult r =
        load_objects("mesh 4 4" + square + "1 2 5\n0 2 3\n1 -5 99999999999999\n1 3 4");
    CHECK(messages(r) ==
          Messages{"a.p3f:7:5: warning: face left out: no vertex 5 in a mesh of 4 vertices",
                   "a.p3f:8:1: warning: face left out: no vertex 0 in a mesh of 4 vertices",
                   "a.p3f:9:3: warning: face left out: no vertex -5 in a mesh of 4 vertices",
                   "a.p3f:9:6: warning: face left out: no vertex 99999999999999 in a mesh of "
                   "4 vertices"});
    REQUIRE(r.scene->geometry.all<Triangle>().size() == 1);
    CHECK(corners_of(*r.scene, 0) == std::vector{corner[0], corner[2], corner[3]});
}

TEST_CASE("faces that name a vertex twice are left out with one warning") {
    const LoadResult r = load_objects("mesh 4 3" + square + "1 1 2\n1 2 3\n3 4 -2");
    CHECK(messages(r) ==
          Messages{"a.p3f:2:1: warning: 2 faces left out: they name a vertex twice"});
    CHECK(r.scene->geometry.all<Triangle>().size() == 1);
}

TEST_CASE("a mesh that breaks off keeps the faces before") {
    const LoadResult r = load_objects("mesh 4 3" + square + "1 2 3\n1 3\ns 0 0 0 1");
    CHECK(messages(r) ==
          Messages{"a.p3f:9:1: warning: expected a whole number for the face of 'mesh', found "
                   "'s'"});
    CHECK(r.scene->geometry.all<Triangle>().size() == 1);
    CHECK(r.scene->geometry.all<Sphere>().size() == 1);
}

TEST_CASE("a mesh whose vertices break off has no faces") {
    const LoadResult r =
        load_objects("mesh 4 2\n0 0 0\n1 0 oops\n1 1 0\n0 1 0\n1 2 3\n1 3 4\ns 0 0 0 1");
    CHECK(messages(r) ==
          Messages{"a.p3f:4:5: warning: expected a number for the vertex of 'mesh', found "
                   "'oops'"});
    CHECK(r.scene->geometry.vertices.empty());
    CHECK(r.scene->geometry.primitives.size() == 1);
}

TEST_CASE("numbers after the last face are one warning") {
    const LoadResult r = load_objects("mesh 4 1" + square + "1 2 3\n1 3 4\ns 0 0 0 1");
    CHECK(messages(r) ==
          Messages{"a.p3f:8:1: warning: expected a keyword after 'mesh', found '1' (words "
                   "skipped: 3)"});
    CHECK(r.scene->geometry.primitives.size() == 2);
}

TEST_CASE("a mesh that announces a billion vertices is left out at once") {
    const LoadResult r =
        load_p3f_text(good_camera + good_material + "mesh 1000000000 1000000000\n0 0 0\n");
    CHECK(messages(r) ==
          Messages{"a.p3f:11:6: warning: the number of vertices of 'mesh' is 1000000000, but "
                   "the rest of the file holds at most 3"});
    REQUIRE(r.scene);
    CHECK(memory_bytes(*r.scene) < 10000);
}

TEST_CASE("a mesh that announces a billion faces has those that are there") {
    const LoadResult r =
        load_p3f_text(good_camera + good_material + "mesh 4 1000000000" + square + "1 2 3");
    CHECK(messages(r) ==
          Messages{"a.p3f:16:6: warning: expected a whole number for the face of 'mesh', found "
                   "the end of the file"});
    REQUIRE(r.scene);
    CHECK(r.scene->geometry.primitives.size() == 1);
    CHECK(memory_bytes(*r.scene) < 10000);
}

TEST_CASE("counts of a mesh below zero leave it out") {
    CHECK(messages(load_objects("mesh -4 2" + square)) ==
          Messages{"a.p3f:2:6: warning: the number of vertices of 'mesh' is negative"});
    const LoadResult r = load_objects("mesh 4 -2" + square + "s 0 0 0 1");
    REQUIRE_FALSE(r.diagnostics.empty());
    CHECK(messages(r)[0] == "a.p3f:2:8: warning: the number of faces of 'mesh' is negative");
    CHECK(r.diagnostics.size() == 1);
}

TEST_CASE("many small meshes take memory in proportion to their size") {
    std::string text;
    for (int i = 0; i < 2000; ++i) text += "mesh 4 1" + square + "1 2 3\n";
    const LoadResult r = load_objects(text);
    CHECK(r.scene->geometry.primitives.size() == 2000);
    CHECK(memory_bytes(*r.scene) < 10 * text.size());
}
