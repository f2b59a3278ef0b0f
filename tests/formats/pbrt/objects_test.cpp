#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;
using namespace etalon::pbrt;

TEST_CASE("an object's shapes are seen only where it is instanced") {
    const Frame frame = good_world(
        "Translate 1 0 0 ObjectBegin \"o\" Translate 0 1 0 Shape \"sphere\" Shape \"disk\" "
        "ObjectEnd "
        "Shape \"cone\" Translate 0 0 1 ObjectInstance \"o\" Scale 2 2 2 ObjectInstance \"o\"");
    REQUIRE(frame.objects.size() == 1);
    const Object& object = frame.objects[0];
    CHECK(object.name == "o");
    REQUIRE(object.shapes.size() == 2);
    CHECK(object.shapes[0].plugin.type->name == "sphere");
    CHECK(image(start(frame, object.shapes[0]), {0, 0, 0}) == Vec3(1, 1, 0));
    REQUIRE(frame.shapes.size() == 1);
    CHECK(image(start(frame, frame.shapes[0]), {0, 0, 0}) == Vec3(1, 0, 0));
    REQUIRE(frame.instances.size() == 2);
    CHECK(frame.instances[0].object == 0);
    CHECK(image(frame.transforms[frame.instances[1].to_world.start], {1, 1, 1}) == Vec3(3, 2, 3));
}

TEST_CASE("ObjectEnd brings the graphics state back") {
    const Frame frame = good_world(
        "ObjectBegin \"o\" Material \"glass\" ReverseOrientation Translate 1 0 0 Shape \"sphere\" "
        "ObjectEnd Shape \"sphere\"");
    const Shape& shape = frame.shapes.at(0);
    CHECK(frame.materials.at(shape.material).plugin.type->name == "matte");
    CHECK_FALSE(shape.reverse_orientation);
    CHECK(shape.to_world == TransformPair{0, 0});
}

TEST_CASE("an object may be defined again; its earlier instances keep the old one") {
    const Frame frame = good_world(
        "ObjectBegin \"o\" Shape \"sphere\" ObjectEnd ObjectInstance \"o\" ObjectBegin \"o\" Shape "
        "\"disk\" ObjectEnd ObjectInstance \"o\"");
    REQUIRE(frame.instances.size() == 2);
    const auto first_shape = [&](std::size_t i) {
        return frame.objects.at(frame.instances[i].object).shapes.at(0).plugin.type->name;
    };
    CHECK(first_shape(0) == "sphere");
    CHECK(first_shape(1) == "disk");
}

TEST_CASE("an object is known everywhere") {
    const Frame frame = good_world(
        "AttributeBegin ObjectBegin \"o\" Shape \"sphere\" ObjectEnd "
        "AttributeEnd ObjectInstance \"o\"");
    CHECK(frame.instances.size() == 1);
}

TEST_CASE("instances of an empty object are none") {
    CHECK(good_world("ObjectBegin \"o\" ObjectEnd ObjectInstance \"o\"").instances.empty());
}

TEST_CASE("an undefined object adds nothing") {
    const Frame frame =
        world_with("ObjectInstance \"p\"", "a.pbrt:1:12: error: no object 'p' is defined");
    CHECK(frame.instances.empty());
}

TEST_CASE("an instance may move") {
    const Frame frame = good_world(
        "ObjectBegin \"o\" Shape \"sphere\" ObjectEnd ActiveTransform "
        "EndTime Translate 1 0 0 ObjectInstance \"o\"");
    CHECK(frame.instances.at(0).to_world.is_animated());
}

TEST_CASE("an instance inside an object is left out") {
    const Frame frame = world_with(
        "ObjectBegin \"o\" Shape \"sphere\" ObjectEnd ObjectBegin \"p\"\nObjectInstance \"o\" "
        "ObjectEnd",
        "a.pbrt:2:1: error: 'ObjectInstance' inside an object is left out");
    CHECK(frame.instances.empty());
}

TEST_CASE("an object inside another takes the shapes up to the first ObjectEnd") {
    const ParsedFile file = parse_world(
        "ObjectBegin \"o\" Shape \"sphere\"\nObjectBegin \"p\" Shape \"disk\" ObjectEnd Shape "
        "\"cone\"\nObjectEnd Shape \"cylinder\"");
    CHECK(messages(file) ==
          Messages{
              "a.pbrt:2:1: error: 'ObjectBegin' inside an object: what follows is of the new one",
              "a.pbrt:3:1: error: 'ObjectEnd' outside of an object"});
    const Frame& frame = file.frames.at(0);
    REQUIRE(frame.objects.size() == 2);
    CHECK(frame.objects[0].shapes.size() == 1);
    CHECK(frame.objects[1].shapes.at(0).plugin.type->name == "disk");
    REQUIRE(frame.shapes.size() == 2);
    CHECK(frame.shapes[0].plugin.type->name == "cone");
    CHECK(frame.shapes[1].plugin.type->name == "cylinder");
}

TEST_CASE("ObjectEnd outside of an object ends attributes all the same") {
    const ParsedFile file =
        parse_world("AttributeBegin Material \"glass\" ObjectEnd Shape \"sphere\"");
    CHECK(messages(file) == Messages{"a.pbrt:1:44: error: 'ObjectEnd' outside of an object"});
    const Frame& frame = file.frames.at(0);
    CHECK(frame.materials.at(frame.shapes.at(0).material).plugin.type->name == "matte");
}
