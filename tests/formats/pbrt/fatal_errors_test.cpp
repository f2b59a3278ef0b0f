// Errors at which pbrt-v3 stops: the message says what was expected, and reading continues.
#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

/// Checks that this statement, followed by a valid one, is a fatal error with this reason.
void check_fatal(const std::string& statement, const std::string& message) {
    const ParsedFile file = parse_world(statement + "\nShape \"sphere\"");
    CAPTURE(statement);
    CHECK(messages(file) == Messages{"a.pbrt:" + message});
    CHECK(file.is_fatal);
    REQUIRE(file.frames.size() == 1);
    CHECK(file.frames[0].shapes.size() == 1);
}

}  // namespace

TEST_CASE("an unknown directive") {
    check_fatal("Shpae \"sphere\"",
                "1:12: error: expected a directive, found 'Shpae'; did you mean 'Shape'?");
    check_fatal("\"sphere\"", "1:12: error: expected a directive, found the string 'sphere'");
    check_fatal("[ 1 2 3 ]", "1:12: error: expected a directive, found '['");
    check_fatal("3", "1:12: error: expected a directive, found '3'");
}

TEST_CASE("a number that is missing, or none") {
    check_fatal("Translate 1 2", "2:1: error: expected a number for 'Translate', found 'Shape'");
    check_fatal("Translate 1 x 2", "1:24: error: expected a number for 'Translate', found 'x'");
    check_fatal("Translate 1 \"2\" 3",
                "1:24: error: expected a number for 'Translate', found the string '2'");
    check_fatal("Scale 1 - 2", "1:20: error: expected a number for 'Scale', found '-'");
    check_fatal("Transform [1 2 3]", "1:28: error: expected a number for 'Transform', found ']'");
    check_fatal("Transform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 7]",
                "1:55: error: expected ']' for 'Transform', found '7'");
    check_fatal("Shape \"sphere\" \"float radius\" x",
                "1:42: error: expected a number for 'radius' of 'Shape', found 'x'");
    check_fatal("Shape \"sphere\" \"float radius\" [ 1 x ]",
                "1:46: error: expected a number for 'radius' of 'Shape', found 'x'");
}

TEST_CASE("a list of strings and numbers") {
    check_fatal("Shape \"sphere\" \"float radius\" [ 1 \"2\" ]",
                "1:46: error: expected only numbers, as before for 'radius' of 'Shape', found the "
                "string '2'");
    check_fatal("Shape \"sphere\" \"float radius\" [ \"1\" 2 ]",
                "1:48: error: expected only strings, as before for 'radius' of 'Shape', found '2'");
}

TEST_CASE("a flag without quotes") {
    check_fatal(
        "Material \"glass\" \"bool remaproughness\" true",
        "1:51: error: expected \"true\" or \"false\" in quotes (without them only since version "
        "4) for 'remaproughness' of 'Material', found 'true'");
}

TEST_CASE("a string that does not end, or with an unknown escape") {
    check_fatal(
        "Shape \"sphere",
        "1:18: error: expected a type in quotes for 'Shape', found a string that does not end "
        "on its line");
    check_fatal(
        "Shape \"sph\\xere\"",
        "1:18: error: expected a type in quotes for 'Shape', found a string with an unknown "
        "escape; there are \\b \\f \\n \\r \\t \\\\ \\' \\\"");
    check_fatal(
        "Shape \"sphere\" \"float radius",
        "1:27: error: expected a parameter for 'Shape', found a string that does not end on its "
        "line");
}

TEST_CASE("a string that is missing") {
    check_fatal("Shape sphere",
                "1:18: error: expected a type in quotes for 'Shape', found 'sphere'");
    check_fatal("NamedMaterial 3",
                "1:26: error: expected a name in quotes for 'NamedMaterial', found '3'");
    check_fatal("Texture \"a\" \"float\"",
                "2:1: error: expected a class in quotes for 'Texture', found 'Shape'");
}

TEST_CASE("an active time that is none") {
    check_fatal(
        "ActiveTransform Both",
        "1:28: error: expected All, StartTime or EndTime for 'ActiveTransform', found 'Both'");
    check_fatal("ActiveTransform \"All\"",
                "1:28: error: expected All, StartTime or EndTime for "
                "'ActiveTransform', found the string 'All'");
}

TEST_CASE("an unknown pixel filter") {
    const ParsedFile file = parse_text("PixelFilter \"lanczos\" WorldBegin WorldEnd");
    CHECK(messages(file) == Messages{"a.pbrt:1:1: error: unknown filter 'lanczos'; 'box' stands in "
                                     "for it; there are: box gaussian mitchell sinc triangle"});
    CHECK(file.is_fatal);
}

TEST_CASE("a fatal error is told after any number of warnings of its kind") {
    std::string text;
    for (int i = 0; i < 21; ++i) text += "Accelerator \"octree\" ";
    const ParsedFile file = parse_text(text + "PixelFilter \"lanczos\" WorldBegin WorldEnd");
    CHECK(file.is_fatal);
    REQUIRE(file.diagnostics.size() == 21);
    CHECK(to_string(file.diagnostics.back()) ==
          "a.pbrt:1:442: error: unknown filter 'lanczos'; 'box' stands in for it; there are: box "
          "gaussian mitchell sinc triangle");
}

TEST_CASE("a file that ends in a statement") {
    for (const char* text : {"WorldBegin Shape", "WorldBegin Translate 1 2",
                             "WorldBegin Shape \"sphere\" \"float radius\"",
                             "WorldBegin Shape \"sphere\" \"float radius\" [ 1"}) {
        CAPTURE(text);
        const ParsedFile file = parse_text(text);
        CHECK(file.is_fatal);
        REQUIRE(file.diagnostics.size() == 2);
        CHECK(file.diagnostics[0].message.find("found the end of the file") != std::string::npos);
        CHECK(file.diagnostics[1].kind == "end");
    }
}

TEST_CASE("errors after which pbrt-v3 continues are not fatal") {
    for (const char* text :
         {"AttributeEnd", "NamedMaterial \"x\"", "ObjectInstance \"x\"", "Camera \"perspective\"",
          "Include \"none\"", "LightSource \"x\"", "Shape \"x\"", "CoordSysTransform \"x\""}) {
        CAPTURE(text);
        const ParsedFile file = parse_world(text);
        CHECK(file.diagnostics.size() == 1);
        CHECK_FALSE(file.is_fatal);
    }
}
