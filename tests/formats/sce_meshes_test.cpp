// Triangles, and meshes from OBJ files.
#include <filesystem>
#include <fstream>

#include "tests/catch.h"
#include "tests/formats/corners.h"
#include "tests/formats/sce_text.h"

using namespace etalon;

namespace {

namespace fs = std::filesystem;

/// A folder with meshes for one test.
struct Meshes {
    Meshes() { fs::create_directories(path); }
    ~Meshes() { fs::remove_all(path); }

    LoadResult load(const std::string& text, LoadOptions options = {}) const {
        options.format = "sce";
        return load_scene_text(text, (path / "a.sce").string(), options);
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path / name, std::ios::binary) << text;
    }

    fs::path path = fs::temp_directory_path() / "etalon_sce_meshes";
};

/// Half of a square, tilted to x and z.
const std::string tilted = "v 0 0 0\nv 1 0 -1\nv 0 1 0\nf 1 2 3\n";

bool is_along(const Vec3& a, const Vec3& b) {
    return max_abs(a.cross(b)) <= 1e-15 * max_abs(a) * max_abs(b) && a.dot(b) > 0;
}

Vec3 geometric_normal(const Scene& s) {
    const std::vector<Vec3> c = corners_of(s, 0);
    return (c[1] - c[0]).cross(c[2] - c[0]);
}

}  // namespace

TEST_CASE("a triangle is moved by the matrix") {
    const LoadResult r = load_sce_text("translate 1 2 3\nscale 2 2 2\n" + unit_triangle);
    CHECK(messages(r).empty());
    REQUIRE(r.scene->geometry.all<Triangle>().size() == 1);
    CHECK(corners_of(*r.scene, 0) == std::vector{Vec3(1, 2, 3), Vec3(3, 2, 3), Vec3(1, 4, 3)});
    CHECK(r.scene->geometry.primitives[0].sides == Sides::both);
}

TEST_CASE("the front of a triangle stays its front where the matrix mirrors") {
    LoadOptions options;
    options.one_sided = true;
    const LoadResult r = load_sce_text("scale -1 1 1\n" + unit_triangle, options);
    CHECK(geometric_normal(*r.scene).z > 0);
    CHECK(r.scene->geometry.primitives[0].sides == Sides::front);
}

TEST_CASE("a triangle without area or under a singular matrix is left out") {
    const LoadResult r = load_sce_text("triangle 0 0 0 1 1 1 2 2 2\nscale 1 1 0\n" + unit_triangle +
                                       "scale 1 1e308 1\nscale 1 1e308 1\n" + unit_triangle);
    CHECK(messages(r) ==
          Messages{"a.sce:1:1: warning: 'triangle' left out: it has no area",
                   "a.sce:3:1: warning: 'triangle' left out: its matrix is singular",
                   "a.sce:6:1: warning: 'triangle' left out: its matrix is not finite"});
    CHECK(r.scene->geometry.primitives.empty());
}

TEST_CASE("a mesh lies beside the scene and is moved by the matrix") {
    const Meshes folder;
    folder.write("half.obj", tilted);
    const LoadResult r = folder.load("translate 0 0 5\nobject_flat half.obj\n");
    CHECK(messages(r).empty());
    REQUIRE(r.scene->geometry.all<Triangle>().size() == 1);
    CHECK(r.scene->geometry.vertices ==
          LargeVector<Vec3>{Vec3(0, 0, 5), Vec3(1, 0, 4), Vec3(0, 1, 5)});
    CHECK(corner_normals(*r.scene, 0).empty());
}

TEST_CASE("a mesh used twice is read once and stands in both places") {
    const Meshes folder;
    folder.write("half.obj", tilted + "f 1 2 9\n");
    const LoadResult r =
        folder.load("object_flat half.obj\ntranslate 1 0 0\nobject_phong half.obj\n");
    CHECK(r.diagnostics.size() == 1);
    CHECK(r.scene->geometry.all<Triangle>().size() == 2);
    CHECK(corners_of(*r.scene, 1)[0] == Vec3(1, 0, 0));
}

TEST_CASE("normals of a smooth mesh stay perpendicular to it under an uneven matrix") {
    const Meshes folder;
    folder.write("half.obj", tilted);  // its normals are computed
    for (const std::string matrix : {"scale 1 1 3", "scale 1 1 -3", "rotate 30 1 2 3\nscale -1 5 1",
                                     "scale .1 .1 .1\nrotate 40 0 1 0\nscale 2 1 1"}) {
        const LoadResult r = folder.load(matrix + "\nobject_phong half.obj\n");
        CAPTURE(matrix);
        REQUIRE(corner_normals(*r.scene, 0).size() == 3);
        for (const Vec3& n : r.scene->geometry.normals)
            CHECK(is_along(n, geometric_normal(*r.scene)));
    }
}

TEST_CASE("the normals of a file go with their corners, mirrored ones too") {
    const Meshes folder;
    folder.write("half.obj", tilted + "vn 1 0 0\nvn 0 1 0\nvn 0 0 1\n");
    const LoadResult plain = folder.load("object_phong half.obj\n");
    CHECK(plain.scene->geometry.normals ==
          LargeVector<Vec3>{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)});
    const LoadResult r = folder.load("scale 1 1 -1\nobject_phong half.obj\n");
    CHECK(corners_of(*r.scene, 0) == std::vector{Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 1)});
    const std::vector<Vec3> normals = corner_normals(*r.scene, 0);
    CHECK(is_along(normals[0], {1, 0, 0}));
    CHECK(is_along(normals[1], {0, 0, -1}));
    CHECK(is_along(normals[2], {0, 1, 0}));
}

TEST_CASE("normals of one length are of unit length under a matrix that scales") {
    const Meshes folder;
    folder.write("half.obj", tilted);
    const LoadResult r = folder.load("rotate 20 1 2 3\nscale 7 7 7\nobject_phong half.obj\n");
    for (const Vec3& n : r.scene->geometry.normals) CHECK(n.dot(n) == Approx(1).epsilon(1e-15));
    const LoadResult tiny = folder.load("scale 1e-300 1e-300 1e-300\nobject_phong half.obj\n");
    CHECK(tiny.scene->geometry.normals ==
          folder.load("object_phong half.obj\n").scene->geometry.normals);
}

TEST_CASE("a mesh that cannot be had is reported each time, and left out") {
    const Meshes folder;
    folder.write("empty.obj", "v 0 0 0\n");
    const LoadResult r =
        folder.load("object_flat none.obj\nobject_phong empty.obj\n" +
                    ("object_flat none.obj\n" + unit_triangle) + "object_flat .\n");
    const std::string at = (folder.path / "a.sce").string() + ":";
    CHECK(
        messages(r) ==
        Messages{at + "1:13: warning: 'object_flat' of 'none.obj' left out: there is no such file",
                 at + "2:14: warning: 'object_phong' of 'empty.obj' left out: it holds no faces",
                 at + "3:13: warning: 'object_flat' of 'none.obj' left out: there is no such file",
                 at + "5:13: warning: 'object_flat' of '.' left out: there is no such file"});
    CHECK(r.scene->geometry.primitives.size() == 1);
}

TEST_CASE("what is wrong in a mesh is said of its own file") {
    const Meshes folder;
    folder.write("bad.obj", tilted + "f 1 2\n");
    const LoadResult r = folder.load("nx x\nobject_flat bad.obj\nny y\n");
    REQUIRE(r.diagnostics.size() == 3);
    CHECK(messages(r)[1] == (folder.path / "bad.obj").string() +
                                ":5:1: warning: face left out: 2 corners, expected at least 3");
    CHECK(r.scene->geometry.primitives.size() == 1);
    LoadOptions strict;
    strict.strict = true;
    CHECK_FALSE(folder.load("object_flat bad.obj\n", strict).scene);
}

TEST_CASE("a mesh under a matrix that loses it is left out") {
    const Meshes folder;
    folder.write("half.obj", tilted);
    const std::string at = (folder.path / "a.sce").string() + ":";
    CHECK(messages(folder.load("scale 0 1 1\nobject_flat half.obj\n")) ==
          Messages{at + "2:1: warning: 'object_flat' left out: its matrix is singular"});
}
