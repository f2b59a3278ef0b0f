#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

std::string material_of(const Frame& frame, std::size_t shape) {
    return std::string(frame.materials.at(frame.shapes.at(shape).material).plugin.type->name);
}

}  // namespace

TEST_CASE("AttributeEnd brings all of the graphics state back") {
    const Frame frame = good_world(
        "MakeNamedMedium \"m\" \"string type\" \"homogeneous\"\n"
        "AttributeBegin Translate 1 0 0 Material \"glass\" ReverseOrientation MediumInterface "
        "\"m\"\n"
        "AreaLightSource \"diffuse\" Shape \"sphere\" AttributeEnd\n"
        "Shape \"sphere\"");
    const Shape& inner = frame.shapes.at(0);
    const Shape& outer = frame.shapes.at(1);
    CHECK(material_of(frame, 0) == "glass");
    CHECK(inner.reverse_orientation);
    CHECK(inner.area_light == 0);
    CHECK(inner.media == MediumInterface{0, 0});
    CHECK(material_of(frame, 1) == "matte");
    CHECK_FALSE(outer.reverse_orientation);
    CHECK(outer.area_light == none);
    CHECK(outer.media == MediumInterface{});
    CHECK(outer.to_world == TransformPair{0, 0});
}

TEST_CASE("AttributeEnd brings the active times back") {
    const Frame frame = good_world(
        "AttributeBegin ActiveTransform EndTime AttributeEnd "
        "Translate 1 0 0 Shape \"sphere\"");
    CHECK_FALSE(frame.shapes.at(0).to_world.is_animated());
}

TEST_CASE("ReverseOrientation toggles") {
    const Frame frame = good_world(
        "ReverseOrientation Shape \"sphere\" ReverseOrientation "
        "Shape \"sphere\"");
    CHECK(frame.shapes.at(0).reverse_orientation);
    CHECK_FALSE(frame.shapes.at(1).reverse_orientation);
}

TEST_CASE("an end without a beginning is left out") {
    world_with("AttributeEnd", "a.pbrt:1:12: error: 'AttributeEnd' ends nothing");
    world_with("TransformEnd", "a.pbrt:1:12: error: 'TransformEnd' ends nothing");
}

TEST_CASE("a block that is not ended is a warning") {
    const Frame frame = world_with("AttributeBegin Shape \"sphere\"",
                                   "a.pbrt:1:12: warning: this block is not ended");
    CHECK(frame.shapes.size() == 1);
    world_with("TransformBegin", "a.pbrt:1:12: warning: this block is not ended");
}

TEST_CASE("an end takes the transformation that was saved last, whoever saved it") {
    const ParsedFile file = parse_world(
        "AttributeBegin Translate 1 0 0 TransformBegin Translate 5 0 0 AttributeEnd Shape "
        "\"sphere\" TransformEnd Shape \"sphere\"");
    CHECK(messages(file) ==
          Messages{"a.pbrt:1:74: warning: 'AttributeEnd' ends what 'TransformBegin' began",
                   "a.pbrt:1:102: warning: 'TransformEnd' ends what 'AttributeBegin' or "
                   "'ObjectBegin' began"});
    const Frame& frame = file.frames.at(0);
    CHECK(image(start(frame, frame.shapes.at(0)), {0, 0, 0}) == Vec3(1, 0, 0));
    CHECK(image(start(frame, frame.shapes.at(1)), {0, 0, 0}) == Vec3(0, 0, 0));
}

TEST_CASE("AttributeEnd after the transformation is already back leaves it") {
    const ParsedFile file =
        parse_world("AttributeBegin TransformEnd Translate 1 0 0 AttributeEnd Shape \"sphere\"");
    const Frame& frame = file.frames.at(0);
    CHECK(image(start(frame, frame.shapes.at(0)), {0, 0, 0}) == Vec3(1, 0, 0));
}

TEST_CASE("a file that ends without WorldEnd still gives its frame") {
    const ParsedFile file = parse_text("WorldBegin Shape \"sphere\"");
    CHECK(messages(file) == Messages{"a.pbrt:1:26: error: the file ends without WorldEnd"});
    REQUIRE(file.frames.size() == 1);
    CHECK(file.frames[0].shapes.size() == 1);
}

TEST_CASE("a file without WorldBegin gives nothing") {
    const ParsedFile file = parse_text("Camera \"perspective\"\n");
    CHECK(messages(file) ==
          Messages{"a.pbrt:2:1: error: the file has no WorldBegin: there is nothing to see"});
    CHECK(file.frames.empty());
    CHECK(parse_text("").frames.empty());
}

TEST_CASE("options after the last WorldEnd give no frame") {
    CHECK(parse_text("WorldBegin WorldEnd Camera \"perspective\"").frames.size() == 1);
}
