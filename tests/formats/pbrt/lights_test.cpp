#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;
using namespace etalon::pbrt;

TEST_CASE("a light has its parameters and the transformation of its place") {
    const Frame frame = good_world(
        "Translate 1 0 0 LightSource \"spot\" \"rgb I\" [1 2 3] \"point "
        "from\" [4 5 6] \"float coneangle\" 12 \"rgb scale\" [2 2 2]");
    const Light& light = frame.lights.at(0);
    CHECK(light.plugin.type->name == "spot");
    CHECK(light.plugin.parameters.color("I") == Color(1, 2, 3));
    CHECK(light.plugin.parameters.vector("from") == Vec3f(4, 5, 6));
    CHECK(light.plugin.parameters.number("coneangle") == 12);
    CHECK(light.plugin.parameters.color("scale") == Color(2.0F));
    CHECK(image(frame.transforms[light.to_world], {0, 0, 0}) == Vec3(1, 0, 0));
}

TEST_CASE("the scale of a light is a colour and no number") {
    const Frame frame = world_with("LightSource \"point\" \"float scale\" 3",
                                   "a.pbrt:1:32: warning: 'float scale' is not used: in the light "
                                   "'point' its type is rgb");
    CHECK(frame.lights.at(0).plugin.parameters.color("scale") == Color(1.0F));
}

TEST_CASE("a light of an unknown type is left out") {
    const Frame frame = world_with("LightSource \"sun\"",
                                   "a.pbrt:1:12: error: unknown light 'sun'; it is left out; there "
                                   "are: point spot distant infinite goniometric projection");
    CHECK(frame.lights.empty());
}

TEST_CASE("a light that would move stays where it is at the start") {
    const Frame frame = world_with("ActiveTransform EndTime Translate 1 0 0\nLightSource \"point\"",
                                   "a.pbrt:2:1: warning: 'LightSource' cannot move: it stays where "
                                   "it is at the start");
    CHECK(frame.lights.at(0).to_world == 0);
}

TEST_CASE("the shapes after an area light are lights, up to the end of its block") {
    const Frame frame = good_world(
        "AttributeBegin AreaLightSource \"area\" \"rgb L\" [1 2 3] \"integer nsamples\" 4 Shape "
        "\"sphere\" Shape \"disk\" AttributeEnd Shape \"sphere\"");
    CHECK(frame.area_lights.size() == 1);
    CHECK(frame.area_lights.at(0).parameters.color("L") == Color(1, 2, 3));
    CHECK(frame.area_lights.at(0).parameters.integer("samples") == 4);
    CHECK(frame.shapes.at(0).area_light == 0);
    CHECK(frame.shapes.at(1).area_light == 0);
    CHECK(frame.shapes.at(2).area_light == none);
}

TEST_CASE("an area light without a name ends the one before") {
    const Frame frame =
        good_world("AreaLightSource \"diffuse\" AreaLightSource \"\" Shape \"sphere\"");
    CHECK(frame.shapes.at(0).area_light == none);
}

TEST_CASE("shapes after an unknown area light do not shine") {
    const Frame frame = world_with(
        "AreaLightSource \"diffuse\" AreaLightSource \"lamp\" Shape \"sphere\"",
        "a.pbrt:1:38: warning: unknown area light 'lamp'; shapes do not shine; there are: diffuse");
    CHECK(frame.shapes.at(0).area_light == none);
}

TEST_CASE("a shape that moves cannot be a light") {
    const Frame frame = world_with(
        "AreaLightSource \"diffuse\" ActiveTransform EndTime Translate 1 0 0\nShape "
        "\"sphere\"",
        "a.pbrt:2:1: warning: a shape that moves cannot be a light");
    CHECK(frame.shapes.at(0).area_light == none);
}

TEST_CASE("a shape of an object cannot be a light") {
    const Frame frame =
        world_with("AreaLightSource \"diffuse\" ObjectBegin \"o\"\nShape \"sphere\" ObjectEnd",
                   "a.pbrt:2:1: warning: a shape of an object cannot be a light");
    CHECK(frame.objects.at(0).shapes.at(0).area_light == none);
}
