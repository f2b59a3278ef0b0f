#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

Parameters shape(const std::string& text) {
    return good_world("Shape " + text).shapes.at(0).plugin.parameters;
}

const std::string triangle =
    "\"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 0 0 0 1 0] ";

}  // namespace

TEST_CASE("a shape has its parameters and its place in the file") {
    const Frame frame = good_world("Shape \"sphere\"\n\"float radius\" 3");
    const Plugin& sphere = frame.shapes.at(0).plugin;
    CHECK(sphere.type->name == "sphere");
    CHECK(sphere.parameters.number("radius") == 3);
    CHECK(sphere.where.line == 2);
    CHECK(sphere.where.column == 1);
}

TEST_CASE("a mesh has its lists") {
    const Parameters mesh = shape(triangle +
                                  "\"normal N\" [0 0 1 0 0 1 0 0 1] \"vector S\" [1 0 0 1 0 "
                                  "0 1 0 0] \"integer faceIndices\" 7");
    CHECK(mesh.integers("indices").size() == 3);
    CHECK(mesh.integers("indices")[2] == 2);
    CHECK(mesh.numbers("P").size() == 9);
    CHECK(mesh.numbers("N").size() == 9);
    CHECK(mesh.numbers("S").size() == 9);
    CHECK(mesh.integers("faceIndices")[0] == 7);
    CHECK(mesh.numbers("uv").empty());
}

TEST_CASE("texture coordinates have two names and two types") {
    CHECK(shape(triangle + "\"point2 uv\" [1 2 3 4 5 6]").numbers("uv").size() == 6);
    CHECK(shape(triangle + "\"point2 st\" [1 2 3 4 5 6]").numbers("uv").size() == 6);
    CHECK(shape(triangle + "\"float uv\" [1 2 3 4 5 6]").numbers("uv")[5] == 6);
    CHECK(shape(triangle + "\"float st\" [1 2 3 4 5 6 7]").numbers("uv").size() == 6);
}

TEST_CASE("a mask is a texture or a number") {
    const Frame frame = good_world("Texture \"t\" \"float\" \"constant\" Shape " + triangle +
                                   "\"texture alpha\" \"t\" \"float shadowalpha\" 0");
    const Parameters& mesh = frame.shapes.at(0).plugin.parameters;
    CHECK(mesh.texture("alpha") == 0U);
    CHECK(mesh.number("shadowalpha") == 0);
}

TEST_CASE("the split depth of a curve is an integer or a number") {
    const std::string curve = "\"curve\" \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0] ";
    CHECK(shape(curve + "\"integer splitdepth\" 4").integer("splitdepth") == 4);
    CHECK(shape(curve + "\"float splitdepth\" 5.5").integer("splitdepth") == 5);
    CHECK(shape(curve + "\"float width\" 7").number("width1") == 7);
}

TEST_CASE("a shape without what it needs is left out") {
    const Frame frame =
        world_with("Shape \"trianglemesh\" \"integer indices\" [0 1 2]",
                   "a.pbrt:1:12: error: the shape 'trianglemesh' is left out: 'point "
                   "P' is missing");
    CHECK(frame.shapes.empty());
    for (const char* type : {"plymesh", "loopsubdiv", "nurbs", "heightfield", "curve"}) {
        CAPTURE(type);
        const ParsedFile file = parse_world(std::string("Shape \"") + type + "\"");
        REQUIRE(file.diagnostics.size() == 1);
        CHECK(file.diagnostics[0].kind == "missing");
        CHECK(file.frames.at(0).shapes.empty());
    }
}

TEST_CASE("an unknown shape is left out") {
    const Frame frame = world_with("Shape \"cube\" Shape \"sphere\"",
                                   "a.pbrt:1:12: warning: unknown shape 'cube'; did you mean "
                                   "'cone'?; it is left out");
    CHECK(frame.shapes.size() == 1);
}

TEST_CASE("shapes of one place share their transformation") {
    const Frame frame = good_world(
        "Translate 1 0 0 Shape \"sphere\" AttributeBegin Shape \"disk\" "
        "AttributeEnd Shape \"cone\"");
    CHECK(frame.transforms.size() == 2);
    CHECK(frame.shapes.at(0).to_world == frame.shapes.at(1).to_world);
    CHECK(frame.shapes.at(0).to_world == frame.shapes.at(2).to_world);
}
