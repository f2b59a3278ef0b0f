// Balls and cylinders.
#include "tests/catch.h"
#include "tests/formats/sce_text.h"

using namespace etalon;

namespace {

/// Returns the map that these lines apply to the unit sphere.
Affine ball(const std::string& lines) {
    const LoadResult r = load_sce_text(lines);
    CAPTURE(lines, messages(r));
    CHECK(r.diagnostics.empty());
    REQUIRE(r.scene->geometry.all<Ellipsoid>().size() == 1);
    return r.scene->geometry.all<Ellipsoid>()[0].to_world;
}

Sphere sphere(const std::string& lines) {
    const LoadResult r = load_sce_text(lines);
    CAPTURE(lines, messages(r));
    CHECK(r.diagnostics.empty());
    REQUIRE(r.scene->geometry.all<Sphere>().size() == 1);
    return r.scene->geometry.all<Sphere>()[0];
}

}  // namespace

TEST_CASE("a ball stays a sphere where the matrix certainly keeps it one") {
    CHECK(sphere("ball 0.5 1 2 3\n").centre == Vec3(1, 2, 3));
    CHECK(sphere("ball 0.5 1 2 3\n").radius == 0.5);
    CHECK(sphere("ball -0.5 1 2 3\n").radius == 0.5);
    const Sphere moved = sphere("translate 1 1 1\nrotate 90 1 0 0\nscale -3 3 3\nball 1 1 1 1\n");
    CHECK(moved.centre == Vec3(-2, -2, 4));
    CHECK(moved.radius == 3);
}

TEST_CASE("under any other matrix a ball is an ellipsoid") {
    const Affine tall = ball("translate 1 0 0\nscale 1 1 1.5\nball 2 0 0 1\n");
    CHECK(tall.x == Vec3(2, 0, 0));
    CHECK(tall.z == Vec3(0, 0, 3));
    CHECK(tall.origin == Vec3(1, 0, 1.5));
    CHECK(ball("rotate 30 0 0 1\nball 1 0 0 0\n").determinant() == Approx(1));
    CHECK(ball("scale 1 -1 2\nball 1 0 0 0\n").y == Vec3(0, -1, 0));
}

TEST_CASE("a cylinder is closed, of radius 1 and height 1 under its matrix") {
    const LoadResult r = load_sce_text("translate 0 0 2\nscale 0.5 1 3\ncylinder\n");
    CHECK(messages(r).empty());
    REQUIRE(r.scene->geometry.all<ClosedCylinder>().size() == 1);
    const Affine& map = r.scene->geometry.all<ClosedCylinder>()[0].to_world;
    CHECK(map.x == Vec3(0.5, 0, 0));
    CHECK(map.z == Vec3(0, 0, 3));
    CHECK(map.origin == Vec3(0, 0, 2));
}

TEST_CASE("a solid without volume is left out") {
    const auto said = [](const std::string& lines) {
        const LoadResult r = load_sce_text(lines);
        CHECK(r.scene->geometry.primitives.empty());
        return messages(r);
    };
    CHECK(said("ball 0 1 2 3\n") ==
          Messages{"a.sce:1:1: warning: 'ball' left out: its radius is 0"});
    CHECK(said("scale 1 0 1\nball 1 1 2 3\ncylinder\n") ==
          Messages{"a.sce:2:1: warning: 'ball' left out: its matrix is singular",
                   "a.sce:3:1: warning: 'cylinder' left out: its matrix is singular"});
    CHECK(said("scale 1e200 1e200 1e200\nball 1e200 0 0 0\n") ==
          Messages{"a.sce:2:1: warning: 'ball' left out: its size is not finite"});
}

TEST_CASE("a solid counts as one primitive of the current surface") {
    const LoadResult r = load_sce_text("cr 1 0 0\nball 1 0 0 0\ncr 0 1 0\ncylinder\n");
    REQUIRE(r.scene->geometry.primitives.size() == 2);
    CHECK(r.scene->geometry.primitives[1].material == 1);
    CHECK(r.scene->geometry.primitives[1].sides == Sides::both);
}
