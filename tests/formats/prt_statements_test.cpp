// from, at, up, angle, resolution, background, light; --legacy prt.
#include <cmath>

#include "tests/catch.h"
#include "tests/formats/prt_text.h"

using namespace etalon;

namespace {

LoadOptions legacy() {
    LoadOptions options;
    options.legacy = true;
    return options;
}

}  // namespace

TEST_CASE("a PRT camera is five statements, its angle the field of view both ways") {
    const LoadResult r =
        load_text("prt", "from 1 2 3\nat 4 5 6\nup 0 0 1\nangle 50\nresolution 800 600\n");
    CHECK(messages(r).empty());
    REQUIRE(r.scene);
    CHECK(r.scene->format == "prt");
    CHECK(r.settings.display_colors);
    CHECK(r.settings.max_depth == 5);
    CHECK_FALSE(r.settings.whitted.normalize_camera_rays);
    const Camera& c = r.scene->camera;
    CHECK(c.eye == Vec3(1, 2, 3));
    CHECK(c.at == Vec3(4, 5, 6));
    CHECK(c.up == Vec3(0, 0, 1));
    CHECK(c.fov_degrees == 50);
    CHECK(c.stretched);
    CHECK(r.settings.resolution.x == 800);
    CHECK(r.settings.resolution.y == 600);
    CHECK(r.settings.pixel_rays == PixelRays::centre);
}

TEST_CASE("a PRT camera that lacks a statement is none") {
    CHECK(messages(load_text("prt", "light 0 0 1\nat 0 0 0\nup 0 1 0\nresolution 9 9\n")) ==
          Messages{"a.prt:2:1: warning: 'at' after lights; PRT's document has it before them",
                   "a.prt:3:1: warning: 'up' after lights; PRT's document has it before them",
                   "a.prt:4:1: warning: 'resolution' after lights; PRT's document has it before "
                   "them",
                   "a.prt:2:1: error: the camera has no from, angle, so nothing can be rendered"});
    CHECK(messages(load_text("prt", "light 0 0 1\n")) ==
          Messages{"a.prt:2:1: error: no camera, so nothing can be rendered"});
    CHECK(messages(load_text("prt", "from 0 0 0\nat 0 0 0\nup 0 1 0\nangle 4\nresolution 9 9")) ==
          Messages{"a.prt:1:1: error: the camera's eye is the point it looks at, so nothing can be "
                   "rendered"});
}

TEST_CASE("a repeated or incomplete PRT camera statement is reported") {
    CHECK(messages(load_prt_text("angle 30")) ==
          Messages{"a.prt:6:1: warning: a second 'angle'; it replaces the first"});
    const LoadResult r = load_prt_text("from 1 2\nlight 1 1 1");
    CHECK(messages(r) ==
          Messages{"a.prt:7:1: warning: expected a number for the eye of 'from', found 'light'"});
    CHECK(r.scene->camera.eye == Vec3(0, 0, 5));
}

TEST_CASE("PRT statements may come in any order, with a warning") {
    const LoadResult r = load_text("prt", red + "sphere 0 0 0 1\nlight 1 2 3\n" + good_lines);
    REQUIRE(r.scene);
    CHECK(r.diagnostics.size() == 6);
    CHECK(messages(r)[0] ==
          "a.prt:3:1: warning: 'light' after objects; PRT's document has it before them");
    CHECK(messages(r)[1] ==
          "a.prt:4:1: warning: 'from' after objects; PRT's document has it before them");
    CHECK(r.scene->whitted().lights.size() == 1);
}

TEST_CASE("a PRT background has a letter or none") {
    for (const std::string letter : {"", " n", " y", " x", "\tz"}) {
        const LoadResult r = load_prt_text("background 0.25 0.5 1" + letter + "\nlight 0 0 1");
        CHECK(messages(r).empty());
        CHECK(r.scene->whitted().environment.background == Color(0.25F, 0.5F, 1));
        CHECK(r.scene->whitted().lights.size() == 1);
    }
    CHECK(load_prt_text("background 0 0 0 no").diagnostics.size() == 1);
    CHECK(load_prt_text("background 0 0 0 1").diagnostics.size() == 1);
}

TEST_CASE("PRT lights are white and share their strength") {
    const LoadResult r = load_prt_text("light 1 2 3\nlight 4 5 6\nlight 7 8 9\nlight 0 0 0");
    CHECK(messages(r).empty());
    REQUIRE(r.scene->whitted().lights.size() == 4);
    for (const Light& light : r.scene->whitted().lights) {
        CHECK(std::get<PointLight>(light).color == Color(0.5F));
    }
    CHECK(std::get<PointLight>(r.scene->whitted().lights[1]).position == Vec3(4, 5, 6));
}

TEST_CASE("tabs and comments may stand anywhere in PRT") {
    const LoadResult r = load_prt_text("light\t1 2 3\n" + red +
                                       "polygon 3 # top\n0 0 0\n\n# here\n1 0 0\n0 1 0 # end");
    CHECK(messages(r).empty());
    CHECK(r.scene->geometry.all<Triangle>().size() == 1);
}

TEST_CASE("legacy PRT has the program's camera and brings bright pixels into range") {
    const LoadResult r = load_prt_text("", legacy());
    CHECK(messages(r).empty());
    const double pi = 3.14159265358979;
    const Camera& c = r.scene->camera;
    CHECK(std::tan(c.fov_degrees / 360 * pi) == Approx(std::tan(40 * pi / 180) / std::sqrt(2.0)));
    CHECK(c.fov_degrees == Approx(61.4).margin(0.05));
    CHECK(c.stretched);
    CHECK(r.settings.pixel_rays == PixelRays::upper_left);
    CHECK(r.settings.whitted.normalize_camera_rays);
}

TEST_CASE("legacy PRT rounds the exponents of highlights") {
    const auto material = [](const std::string& exponent) {
        const LoadResult r =
            load_prt_text("surface 0 0 0 0 0 0 0 0 0 0 0 1 1 1 1 1 1 " + exponent + " 1", legacy());
        return r.scene->whitted().materials.at(0);
    };
    CHECK(material("2.5").shininess == 3);
    CHECK(material("2.5").specular == Color(1.0F));
    CHECK(material("0.4").specular == Color(0.0F));
}

TEST_CASE("legacy PRT turns the image upside down beyond an angle of 90 degrees") {
    const LoadResult wide =
        load_text("prt", "from 0 0 5\nat 0 0 0\nup 0 1 0\nangle 140\nresolution 9 9\n", legacy());
    CHECK(messages(wide).empty());
    const LoadResult narrow =
        load_text("prt", "from 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nresolution 9 9\n", legacy());
    CHECK(wide.scene->camera.up == Vec3(0, -1, 0));
    CHECK(narrow.scene->camera.up == Vec3(0, 1, 0));
    CHECK(wide.scene->camera.fov_degrees == Approx(narrow.scene->camera.fov_degrees));
}
