// Camera and image.
#include <variant>

#include "tests/catch.h"
#include "tests/formats/sce_text.h"

using namespace etalon;

TEST_CASE("camera and image are plain assignments, independent of matrices and blocks") {
    const LoadResult r = load_sce_text(
        "{\nscale 2 2 2\neyepos 9 9 9\neyepos 1 2 3\neyedir 0 4 0\neyeup 0 0 2\nwdist 20\n"
        "fovy_deg 60\nnx 64\nny 48\nmax_recursion 4\naasample 3\nbackground .25 .5 1\n}\n");
    CHECK(messages(r).empty());
    const Camera& c = r.scene->camera;
    CHECK(c.eye == Vec3(1, 2, 3));
    CHECK(c.at - c.eye == Vec3(0, 2, 0));
    CHECK(c.up == Vec3(0, 0, 2));
    CHECK(c.fov_degrees == 60);
    CHECK(r.settings.resolution.x == 64);
    CHECK(r.settings.resolution.y == 48);
    CHECK(c.aperture == 0);
    CHECK(r.settings.max_depth == 5);
    CHECK(r.settings.samples_per_pixel == 9);
    CHECK(r.scene->whitted().environment.background == Color(0.25F, 0.5F, 1));
}

TEST_CASE("a direction keeps its digits however far the eye is from the origin") {
    const LoadResult r = load_sce_text("eyepos 3e20 0 0\neyedir -1 1e-9 0\n");
    const Camera& c = r.scene->camera;
    CHECK((c.at - c.eye).y / (c.at - c.eye).x == Approx(-1e-9).epsilon(1e-15));
}

TEST_CASE("settings out of range are left out") {
    const LoadResult r =
        load_sce_text("nx 0\nny 65537\nfovy_deg 180\naasample -1\nmax_recursion 1000\nnx 4.5\n");
    CHECK(messages(r) ==
          Messages{"a.sce:1:4: warning: 'nx' is 0; expected 1 to 65536",
                   "a.sce:2:4: warning: 'ny' is 65537; expected 1 to 65536",
                   "a.sce:3:1: warning: 'fovy_deg' is 180; expected more than 0 and less than 180",
                   "a.sce:4:10: warning: 'aasample' is -1; expected 0 to 1024",
                   "a.sce:5:15: warning: 'max_recursion' is 1000; expected 0 to 999",
                   "a.sce:6:4: warning: expected a whole number for the number of 'nx', found "
                   "'4.5'"});
    CHECK(r.settings.resolution.x == 100);
    CHECK(r.settings.samples_per_pixel == 0);
}

TEST_CASE("a camera next to the origin looks at a point at a distance that has a square") {
    const LoadResult r = load_sce_text("eyepos 1e-300 0 0\neyedir 0 0 -1e-300\n");
    REQUIRE(r.scene);
    CHECK(max_abs(r.scene->camera.at - r.scene->camera.eye) >= 1e-150);
}

TEST_CASE("a camera that cannot see is an error at the line that makes it so") {
    const auto error = [](const std::string& text) {
        const LoadResult r = load_sce_text(text);
        CHECK_FALSE(r.scene);
        return messages(r).back();
    };
    const std::string end = ", so nothing can be rendered";
    CHECK(error("nx 8\neyedir 0 0 0\n") == "a.sce:2:1: error: 'eyedir' is zero" + end);
    CHECK(error("eyedir 0 1 0\n") == "a.sce:1:1: error: 'eyeup' is along 'eyedir'" + end);
    CHECK(error("eyeup 0 0 -3\n") == "a.sce:1:1: error: 'eyeup' is along 'eyedir'" + end);
    CHECK(error("eyeup 0 0 0\n") == "a.sce:1:1: error: 'eyeup' is along 'eyedir'" + end);
    CHECK(error("eyepos 0 0 1e200\n") ==
          "a.sce:1:1: error: 'eyepos' is 1e+200 from the origin; expected at most 5e+149" + end);
    // The point looked at keeps no digit of the direction but that along eyeup.
    CHECK(error("eyedir 0 1e38 -1\neyepos 0 0 5\n") ==
          "a.sce:1:1: error: 'eyeup' is along 'eyedir'" + end);
}

TEST_CASE("a point light is moved by the matrix, its colour is not") {
    const LoadResult r = load_sce_text("translate 1 0 0\nscale 2 2 2\npointlight 1 2 3 .25 .5 1\n");
    REQUIRE(r.scene->whitted().lights.size() == 1);
    const auto& light = std::get<PointLight>(r.scene->whitted().lights[0]);
    CHECK(light.position == Vec3(3, 4, 6));
    CHECK(light.color == Color(0.25F, 0.5F, 1));
}

TEST_CASE("an area light of half side w is a square that takes one point of each sample") {
    const LoadResult r =
        load_sce_text("translate 1 0 5\nscale 2 4 1\narealight 0.25 .25 .5 1\n" + unit_triangle);
    CHECK(messages(r).empty());
    REQUIRE(r.scene->whitted().lights.size() == 1);
    const auto& light = std::get<QuadLight>(r.scene->whitted().lights[0]);
    CHECK(light.corner == Vec3(0.5, -1, 5));
    CHECK(light.edge1 == Vec3(1, 0, 0));
    CHECK(light.edge2 == Vec3(0, 2, 0));
    CHECK(light.color == Color(0.25F, 0.5F, 1));
    CHECK(light.samples == 1);
    CHECK(r.scene->geometry.primitives.size() == 1);  // it is not seen
}

TEST_CASE("a light whose position is not finite is left out") {
    const std::string far = "scale 1e200 1e200 1e200\nscale 1e200 1 1\n";
    CHECK(messages(load_sce_text(far + "pointlight 1 0 0 1 1 1\narealight 1 1 1 1\n")) ==
          Messages{"a.sce:3:1: warning: 'pointlight' left out: its position is not finite",
                   "a.sce:4:1: warning: 'arealight' left out: its position is not finite"});
}
