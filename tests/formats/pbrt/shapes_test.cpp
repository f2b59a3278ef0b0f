#include "core/formats/load.h"
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

TEST_CASE("the sign of a radius has no effect") {
    const auto only_shape = [](const std::string& shape) {
        const std::string text = "WorldBegin Shape " + shape + " \"float phimax\" 90 WorldEnd";
        const LoadResult r = load_scene_text(text, "a.pbrt", {});
        CHECK(r.diagnostics.empty());
        REQUIRE(r.scene->geometry.primitives.size() == 1);
        return r.scene->geometry.all<Revolved>()[0].to_world;
    };
    for (const std::string name : {"cylinder", "cone", "paraboloid", "sphere", "disk"}) {
        const std::string radius = "\"" + name + "\" \"float radius\" ";
        CHECK(only_shape(radius + "-2") == only_shape(radius + "2"));
    }
    CHECK(only_shape("\"disk\" \"float innerradius\" -.5") ==
          only_shape("\"disk\" \"float innerradius\" .5"));
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

TEST_CASE("a mask is not used with several numbers") {
    const Frame frame = world_with(
        "Shape " + triangle + "\"float alpha\" [0 1]",
        fmt::format("a.pbrt:1:{}: warning: 'alpha' is not used: it takes one value, not 2",
                    18 + triangle.size()));
    CHECK(frame.shapes.at(0).plugin.parameters.number("alpha") == 1);
}

TEST_CASE("a nurbs has points of one kind") {
    const std::string patch =
        "Shape \"nurbs\" \"integer nu\" 2 \"integer nv\" 2 \"integer uorder\" 2 "
        "\"integer vorder\" 2 \"float uknots\" [0 0 1 1] \"float vknots\" [0 0 1 1] ";
    const std::string points = "\"point P\" [0 0 0 1 0 0 0 1 0 1 1 0] ";
    const std::string weighted = "\"float Pw\" [0 0 0 1 1 0 0 1 0 1 0 1 1 1 0 1] ";
    CHECK(good_world(patch + points).shapes.size() == 1);
    CHECK(good_world(patch + weighted).shapes.size() == 1);
    CHECK(world_with(patch + weighted + points,
                     "a.pbrt:1:12: warning: 'Pw' is not used: the points 'P' are given, too")
              .shapes.size() == 1);
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

TEST_CASE("a curve has as many points as its basis and degree ask for") {
    const auto points = [](int count) {
        std::string list = "\"point P\" [";
        for (int i = 0; i < count; ++i) list += std::to_string(i) + " 0 0 ";
        return list + "] ";
    };
    const auto is_made = [&](int count, const std::string& parameters) {
        const ParsedFile file = parse_world("Shape \"curve\" " + points(count) + parameters);
        CHECK(file.diagnostics.size() == 1 - file.frames.at(0).shapes.size());
        return file.frames.at(0).shapes.size() == 1;
    };
    for (const int count : {4, 7, 10}) CHECK(is_made(count, ""));
    for (const int count : {1, 3, 5, 6, 8}) CHECK_FALSE(is_made(count, ""));
    for (const int count : {3, 5, 7}) CHECK(is_made(count, "\"integer degree\" 2"));
    for (const int count : {2, 4}) CHECK_FALSE(is_made(count, "\"integer degree\" 2"));
    for (const int count : {4, 5, 6}) CHECK(is_made(count, "\"string basis\" \"bspline\""));
    CHECK_FALSE(is_made(3, "\"string basis\" \"bspline\""));
    CHECK_FALSE(is_made(5, "\"integer degree\" 4"));
    world_with(
        "Shape \"curve\" " + points(5),
        "a.pbrt:1:12: error: the shape 'curve' is left out: a Bezier curve of degree 3 has 4 "
        "points and 3 more for each further segment, not 5");
}

TEST_CASE("a curve of an unknown basis is left out") {
    const Frame frame = world_with(
        "Shape \"curve\" \"string basis\" \"hermite\" \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0]",
        "a.pbrt:1:12: error: the shape 'curve' is left out: its basis is bezier or bspline, not "
        "'hermite'");
    CHECK(frame.shapes.empty());
}

TEST_CASE("a ribbon has a normal more than segments, and no other curve has any") {
    const std::string curve = "Shape \"curve\" \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0] ";
    const std::string ribbon = curve + "\"string type\" \"ribbon\" ";
    CHECK(good_world(ribbon + "\"normal N\" [0 0 1 0 0 1]").shapes.size() == 1);
    world_with(ribbon + "\"normal N\" [0 0 1 0 0 1 0 0 1 0 0 1]",
               "a.pbrt:1:12: error: the shape 'curve' is left out: a ribbon of 1 segments has 2 "
               "normals, not 4");
    world_with(ribbon,
               "a.pbrt:1:12: error: the shape 'curve' is left out: a ribbon of 1 segments "
               "has 2 normals, not 0");
    CHECK(world_with(curve + "\"normal N\" [0 0 1 0 0 1]",
                     "a.pbrt:1:12: warning: only a curve of type 'ribbon' has normals: they are "
                     "ignored")
              .shapes.size() == 1);
}

TEST_CASE("a curve of an unknown type is a cylinder") {
    const ParsedFile file = parse_world(
        "Shape \"curve\" \"string type\" \"tube\" \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0]");
    CHECK(messages(file) == Messages{"a.pbrt:1:26: error: unknown 'type' 'tube'; it is 'cylinder' "
                                     "instead; there are: flat ribbon cylinder"});
    CHECK(file.frames.at(0).shapes.at(0).plugin.parameters.string("type") == "cylinder");
}

TEST_CASE("an unknown shape is left out") {
    const Frame frame = world_with(
        "Shape \"cube\" Shape \"sphere\"",
        "a.pbrt:1:12: warning: unknown shape 'cube'; it is left out; did you mean 'curve'?");
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
