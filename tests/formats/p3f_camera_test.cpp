#include "tests/catch.h"
#include "tests/formats/p3f_text.h"

using namespace etalon;

namespace {

const std::string errors_end = ", so nothing can be rendered";

/// A camera block with one line replaced. The lines are numbered from 2, after "camera".
std::string camera_with(const std::string& name, const std::string& line) {
    std::string text = good_camera;
    const std::size_t start = text.find("\n" + name + " ") + 1;
    return text.replace(start, text.find('\n', start) - start, line);
}

}  // namespace

TEST_CASE("a camera of the new dialect is read") {
    const LoadResult r = load_p3f_text(
        "camera\neye 1 2 3\nat 4 5 6\nup 0 0 1\nangle 50\nhither 0.01\nresolution 800 600\n"
        "aperture 12\nfocal 1.5\n");
    CHECK(messages(r).empty());
    REQUIRE(r.scene);
    const Camera& c = r.scene->camera;
    CHECK(c.eye == Vec3(1, 2, 3));
    CHECK(c.at == Vec3(4, 5, 6));
    CHECK(c.up == Vec3(0, 0, 1));
    CHECK(c.fov_degrees == 50);
    CHECK(r.settings.resolution.x == 800);
    CHECK(r.settings.resolution.y == 600);
    CHECK(c.aperture == 12);
    CHECK(c.focal == 1.5);
}

TEST_CASE("a camera of the old dialect is read, mixed and without a lens too") {
    const LoadResult old =
        load_p3f_text("v\nfrom 1 2 3\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 4 3\n");
    CHECK(messages(old).empty());
    CHECK(old.scene->camera.eye == Vec3(1, 2, 3));
    CHECK(old.scene->camera.aperture == 0);
    CHECK(old.scene->camera.focal == 1);
    const LoadResult mixed =
        load_p3f_text("camera from 1 2 3 at 0 0 0 up 0 1 0 angle 45 resolution 4 3");
    CHECK(messages(mixed).empty());
    CHECK(mixed.scene->camera.eye == Vec3(1, 2, 3));
}

TEST_CASE("the lines of a camera may have any order") {
    const LoadResult r = load_p3f_text(
        "v focal 2 resolution 4 3 aperture 1 angle 45 up 0 1 0 at 0 0 0 from 1 2 3\ns 0 0 0 1");
    CHECK(r.scene->camera.eye == Vec3(1, 2, 3));
    CHECK(r.scene->camera.focal == 2);
    CHECK(r.scene->geometry.all<Sphere>().size() == 1);
}

TEST_CASE("a wrong word in a camera is taken for the expected one if the numbers fit") {
    const LoadResult r = load_p3f_text(camera_with("at", "towards 1 1 1"));
    CHECK(messages(r) ==
          Messages{"a.p3f:3:1: warning: expected 'at', found 'towards'; read as 'at'"});
    CHECK(r.scene->camera.at == Vec3(1, 1, 1));
}

TEST_CASE("a wrong word in a camera whose numbers do not fit is left out") {
    const LoadResult r = load_p3f_text(camera_with("resolution", "yon 1000\nresolution 40 30"));
    CHECK(messages(r) == Messages{"a.p3f:7:1: warning: 'yon' is not part of a camera"});
    CHECK(r.settings.resolution.x == 40);
    CHECK(r.scene->camera.focal == 1);
}

TEST_CASE("stray numbers in a camera are one warning") {
    const LoadResult r = load_p3f_text(camera_with("angle", "angle 45 1 2 3 4 5"));
    CHECK(messages(r) == Messages{"a.p3f:5:10: warning: '1' is not part of a camera"});
    CHECK(r.settings.resolution.x == 40);
}

TEST_CASE("a bad number in a camera costs its line only") {
    const LoadResult r = load_p3f_text(camera_with("hither", "hither near"));
    CHECK(messages(r) ==
          Messages{"a.p3f:6:8: warning: expected a number for the hither of 'camera', found "
                   "'near'"});
    REQUIRE(r.scene);
    CHECK(r.settings.resolution.x == 40);
}

TEST_CASE("a line given twice is a warning, and the later one counts") {
    const LoadResult r = load_p3f_text(camera_with("angle", "angle 45\nangle 60"));
    CHECK(messages(r) == Messages{"a.p3f:6:1: warning: a second 'angle'; it replaces the first"});
    CHECK(r.scene->camera.fov_degrees == 60);
}

TEST_CASE("a second camera is a warning, and it counts") {
    const LoadResult r = load_p3f_text(good_camera + camera_with("eye", "eye 0 0 9"));
    CHECK(messages(r) == Messages{"a.p3f:10:1: warning: a second camera; it replaces the first"});
    CHECK(r.scene->camera.eye == Vec3(0, 0, 9));
}

TEST_CASE("a bad camera beside a good one is only a warning") {
    const Messages expected = {
        "a.p3f:10:1: warning: the camera has no eye, at, up, angle, resolution; "
        "this camera is left out"};
    const LoadResult r = load_p3f_text(good_camera + "v\n");
    CHECK(messages(r) == expected);
    CHECK(r.scene);
    CHECK(load_p3f_text("v\n" + good_camera).scene);
}

TEST_CASE("without a camera nothing can be rendered") {
    const LoadResult r = load_p3f_text("s 0 0 0 1\n");
    CHECK_FALSE(r.scene);
    CHECK(messages(r).back() == "a.p3f:2:1: error: no camera" + errors_end);
}

TEST_CASE("an unusable camera is an error with the reason") {
    const auto error = [](const std::string& name, const std::string& line) {
        const LoadResult r = load_p3f_text(camera_with(name, line));
        CHECK_FALSE(r.scene);
        return messages(r).back();
    };
    const std::string start = "a.p3f:1:1: error: ";
    const std::string sides = "; expected 1 to 65536 pixels a side" + errors_end;
    CHECK(error("resolution", "resolution 0 30") == start + "the resolution is 0 x 30" + sides);
    CHECK(error("resolution", "resolution 40 -3") == start + "the resolution is 40 x -3" + sides);
    CHECK(error("resolution", "resolution 65537 3") ==
          start + "the resolution is 65537 x 3" + sides);
    CHECK(error("resolution", "resolution 4 4.5") ==
          start + "the camera has no resolution" + errors_end);
    CHECK(error("at", "") == start + "the camera has no at" + errors_end);
    CHECK(error("at", "at 0 0 5") ==
          start + "the camera's eye is the point it looks at" + errors_end);
    CHECK(error("up", "up 0 0 3") == start + "'up' is along the view" + errors_end);
    CHECK(error("up", "up 0 0 0") == start + "'up' is along the view" + errors_end);
    const std::string range = "; expected more than 0 and less than 180" + errors_end;
    CHECK(error("angle", "angle 0") == start + "the angle is 0" + range);
    CHECK(error("angle", "angle 180") == start + "the angle is 180" + range);
    CHECK(load_p3f_text(camera_with("resolution", "resolution 65536 1")).scene);
}

TEST_CASE("a camera is usable where the squares of lengths are in range") {
    for (const std::string distance : {"1e-150", "1e+150"}) {
        CHECK(load_p3f_text(camera_with("eye", "eye 0 0 " + distance)).scene);
    }
    for (const std::string distance : {"1e-151", "1e+151", "1e+308"}) {
        const LoadResult r = load_p3f_text(camera_with("eye", "eye 0 0 " + distance));
        CHECK_FALSE(r.scene);
        CHECK(messages(r).back() == "a.p3f:1:1: error: the camera's eye is " + distance +
                                        " from the point it looks at; expected 1e-150 to 1e+150" +
                                        errors_end);
    }
    CHECK(load_p3f_text(camera_with("up", "up 0 1e-300 0")).scene);
}

TEST_CASE("a lens that is none becomes a pinhole") {
    const LoadResult r = load_p3f_text(camera_with("aperture", "aperture -2"));
    CHECK(messages(r) ==
          Messages{"a.p3f:1:1: warning: aperture -2 with focal 1 is not a lens; taken as a "
                   "pinhole"});
    CHECK(r.scene->camera.aperture == 0);
    std::string without_focus = camera_with("aperture", "aperture 2");
    without_focus.replace(without_focus.find("focal 1"), 7, "focal 0");
    CHECK(load_p3f_text(without_focus).diagnostics.size() == 1);
    CHECK(load_p3f_text(without_focus).scene->camera.aperture == 0);
    CHECK(load_p3f_text(camera_with("focal", "focal 0")).diagnostics.empty());
}
