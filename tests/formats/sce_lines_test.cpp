// Forms that a line of an SCE file may have.
#include <array>

#include "tests/catch.h"
#include "tests/formats/corners.h"
#include "tests/formats/sce_text.h"

using namespace etalon;

namespace {

/// Fills the stack with non-zero bytes, so that uninitialised variables of functions called next
/// are detected.
[[gnu::noinline]] void fill_stack() {
    std::array<volatile unsigned char, 1 << 16> bytes;
    for (volatile unsigned char& byte : bytes) byte = 0x3f;
}

}  // namespace

TEST_CASE("without eyepos the camera is at the origin, not uninitialised") {
    fill_stack();
    const LoadResult r = load_sce_text("# nothing\n");
    REQUIRE(r.scene);
    CHECK(r.scene->camera.eye == Vec3(0));
}

TEST_CASE("an empty SCE scene has the course's defaults") {
    const LoadResult r = load_sce_text("# nothing\n");
    CHECK(messages(r).empty());
    REQUIRE(r.scene);
    const Scene& s = *r.scene;
    CHECK(s.format == "sce");
    CHECK(r.settings.display_colors);
    CHECK(s.whitted().environment.background == Color(0, 0, 0.3F));
    CHECK(r.settings.max_depth == 7);
    CHECK(r.settings.samples_per_pixel == 0);
    CHECK(s.camera.eye == Vec3(0));
    CHECK(s.camera.at == Vec3(0, 0, -1));
    CHECK(s.camera.up == Vec3(0, 1, 0));
    CHECK(s.camera.fov_degrees == 45);
    CHECK(r.settings.resolution == Imath::V2i(100, 100));
}

TEST_CASE("the magic of the first line is not needed") {
    CHECK(messages(load_sce_text("sce1.0\nnx 8\n")).empty());
    CHECK(messages(load_sce_text("nx 8\n")).empty());
}

TEST_CASE("blanks, comments and CRLF do not matter") {
    const LoadResult r = load_sce_text(
        "sce1.0 \r\n\r\n \t\r\n\t# a comment\r\n\tnx\t 8  \r\n ny 6 # rows\r\n#ny 7\r\n");
    CHECK(messages(r).empty());
    CHECK(r.settings.resolution.x == 8);
    CHECK(r.settings.resolution.y == 6);
}

TEST_CASE("a command does not run over the end of its line") {
    const LoadResult r = load_sce_text("eyepos 1 2\n3\nny 6");
    CHECK(messages(r) ==
          Messages{"a.sce:1:11: warning: expected 3 values after 'eyepos', found 2; this line is "
                   "left out",
                   "a.sce:2:1: warning: unknown command '3'"});
    CHECK(r.scene->camera.eye == Vec3(0));
    CHECK(r.settings.resolution.y == 6);
}

TEST_CASE("a wrong number of values costs the line, of a state command too") {
    const auto message = [](const std::string& line) {
        const LoadResult r = load_sce_text(line + "\n" + unit_triangle);
        CAPTURE(line);
        REQUIRE(r.diagnostics.size() == 1);
        REQUIRE(r.scene->geometry.primitives.size() == 1);
        CHECK(r.scene->whitted().materials[0].diffuse == Color(1.0F));
        CHECK(corners_of(*r.scene, 0)[1] == Vec3(1, 0, 0));
        return messages(r)[0];
    };
    const auto expected = [](const std::string& place, const std::string& numbers) {
        return "a.sce:1:" + place + ": warning: expected " + numbers + "; this line is left out";
    };
    CHECK(message("cr .5 .5") == expected("9", "3 values after 'cr', found 2"));
    CHECK(message("cr .5 .5 .5 .5") == expected("13", "3 values after 'cr', found 4"));
    CHECK(message("scale 2") == expected("8", "3 values after 'scale', found 1"));
    CHECK(message("{ 1 2") == expected("3", "0 values after '{', found 2"));
    CHECK(message("triangle 0 0 0 1 1 1") == expected("21", "9 values after 'triangle', found 6"));
    CHECK(message("pop_matrix now") == expected("12", "0 values after 'pop_matrix', found 1"));
}

TEST_CASE("a value that is no number costs the line") {
    const LoadResult r = load_sce_text("scale 1 2 3x\ntranslate 1 nan 0\n" + unit_triangle);
    CHECK(messages(r) ==
          Messages{"a.sce:1:11: warning: expected a number for the factors of 'scale', found '3x'",
                   "a.sce:2:13: warning: expected a number for the offset of 'translate', found "
                   "'nan', which is not finite"});
    CHECK(corners_of(*r.scene, 0)[1] == Vec3(1, 0, 0));
}

TEST_CASE("a keyword is a whole word") {
    const LoadResult r = load_sce_text("triangleX 0 0 0 1 0 0 0 1 0\n{nx 5\nNX 5\n");
    CHECK(messages(r) ==
          Messages{"a.sce:1:1: warning: unknown command 'triangleX'; did you mean 'triangle'?",
                   "a.sce:2:1: warning: unknown command '{nx'; did you mean 'nx'?",
                   "a.sce:3:1: warning: unknown command 'NX'; did you mean 'nx'?"});
    CHECK(r.scene->geometry.primitives.empty());
}

TEST_CASE("the commands of one private program are named as such") {
    CHECK(messages(load_sce_text("alpha 0.5\n")) ==
          Messages{"a.sce:1:1: warning: 'alpha' is a private extension of one program; it is left "
                   "out"});
}

TEST_CASE("end ends the scene, and the rest of the file is not read") {
    const LoadResult r = load_sce_text("nx 8\nend\nnx 9\nthese are notes\n");
    CHECK(messages(r).empty());
    CHECK(r.settings.resolution.x == 8);
}

TEST_CASE("--strict makes a warning an error") {
    LoadOptions strict;
    strict.strict = true;
    CHECK_FALSE(load_sce_text("nx\n", strict).scene);
    CHECK(load_sce_text("nx 8\n", strict).scene);
}
