#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

const Material& material(const Frame& frame, std::size_t shape = 0) {
    return frame.materials.at(frame.shapes.at(shape).material);
}

Color diffuse(const Frame& frame, std::size_t shape = 0) {
    return material(frame, shape).plugin.parameters.color("Kd");
}

const std::string red = "\"rgb Kd\" [1 0 0] ", green = "\"rgb Kd\" [0 1 0] ";
const std::string sphere = "Shape \"sphere\" ";

}  // namespace

TEST_CASE("the material is matte at first") {
    const Frame frame = good_world(sphere);
    CHECK(material(frame).plugin.type->name == "matte");
    CHECK(diffuse(frame) == Color(0.5F));
}

TEST_CASE("a material lasts to the end of its block") {
    const Frame frame =
        good_world("Material \"matte\" " + red + sphere + "AttributeBegin Material \"matte\" " +
                   green + sphere + "AttributeEnd " + sphere);
    CHECK(diffuse(frame, 0) == Color(1, 0, 0));
    CHECK(diffuse(frame, 1) == Color(0, 1, 0));
    CHECK(diffuse(frame, 2) == Color(1, 0, 0));
}

TEST_CASE("equal materials are one") {
    const Frame frame =
        good_world("Material \"matte\" " + red + sphere + "Material \"matte\" " + green + sphere +
                   "MakeNamedMaterial \"a\" \"string type\" \"matte\" " + red +
                   "NamedMaterial \"a\" " + sphere);
    CHECK(frame.materials.size() == 2);
    CHECK(frame.shapes.at(0).material == frame.shapes.at(2).material);
}

TEST_CASE("a material without a name, or none, is no surface") {
    for (const char* name : {"\"\"", "\"none\""}) {
        const Frame frame =
            good_world(std::string("Material ") + name + " \"float any\" 3 " + sphere);
        CHECK(material(frame).plugin.type->name == "none");
    }
}

TEST_CASE("an unknown material is matte of the same parameters") {
    const Frame frame = world_with("Material \"mate\" " + red + sphere,
                                   "a.pbrt:1:12: warning: unknown material 'mate'; 'matte' stands "
                                   "in for it; did you mean 'matte'?");
    CHECK(material(frame).plugin.type->name == "matte");
    CHECK(diffuse(frame) == Color(1, 0, 0));
}

TEST_CASE("a named material is used by its name") {
    const Frame frame = good_world("MakeNamedMaterial \"a\" \"string type\" \"plastic\" " + red +
                                   "NamedMaterial \"a\" " + sphere);
    CHECK(material(frame).plugin.type->name == "plastic");
    CHECK(diffuse(frame) == Color(1, 0, 0));
}

TEST_CASE("a material defined in a block vanishes at its end") {
    const Frame frame = world_with(
        "Material \"glass\" AttributeBegin MakeNamedMaterial \"a\" "
        "\"string type\" \"mirror\" AttributeEnd\nNamedMaterial \"a\" " +
            sphere,
        "a.pbrt:2:1: error: no material 'a' is defined; the current one "
        "stays");
    CHECK(material(frame).plugin.type->name == "glass");
}

TEST_CASE("a material defined again in a block is the old one after it") {
    const std::string make = "MakeNamedMaterial \"a\" \"string type\" \"matte\" ";
    const std::string text = make + red + "\nAttributeBegin " + make + green +
                             "NamedMaterial \"a\" " + sphere + "AttributeEnd NamedMaterial \"a\" " +
                             sphere;
    const Frame frame = world_with(text, "a.pbrt:2:16: warning: the material 'a' is defined again");
    CHECK(diffuse(frame, 0) == Color(0, 1, 0));
    CHECK(diffuse(frame, 1) == Color(1, 0, 0));
}

TEST_CASE("an object is a block of names too") {
    world_with(
        "ObjectBegin \"o\" MakeNamedMaterial \"a\" \"string type\" \"matte\" ObjectEnd\n"
        "NamedMaterial \"a\"",
        "a.pbrt:2:1: error: no material 'a' is defined; the current one stays");
}

TEST_CASE("a transform block is no block of names") {
    good_world(
        "TransformBegin MakeNamedMaterial \"a\" \"string type\" \"matte\" TransformEnd "
        "NamedMaterial \"a\"");
}

TEST_CASE("what used a material before it was defined again keeps the old one") {
    const std::string make = "MakeNamedMaterial \"a\" \"string type\" \"matte\" ";
    const Frame frame = world_with(make + red + "NamedMaterial \"a\"\n" + make + green + sphere,
                                   "a.pbrt:2:1: warning: the material 'a' is defined again");
    CHECK(diffuse(frame) == Color(1, 0, 0));
}

TEST_CASE("a named material without a type is no surface") {
    const Frame frame =
        world_with("MakeNamedMaterial \"a\" NamedMaterial \"a\" " + sphere,
                   "a.pbrt:1:12: error: 'MakeNamedMaterial' has no \"string type\"");
    CHECK(material(frame).plugin.type->name == "none");
}

TEST_CASE("a mix has the numbers of two named materials") {
    const Frame frame = good_world(
        "MakeNamedMaterial \"a\" \"string type\" \"glass\" MakeNamedMaterial \"b\" \"string type\" "
        "\"mirror\" Material \"mix\" \"string namedmaterial1\" \"b\" \"string namedmaterial2\" "
        "\"a\" "
        "\"rgb amount\" [.1 .2 .3] " +
        sphere);
    const Material& mix = material(frame);
    CHECK(frame.materials.at(mix.mixed[0]).plugin.type->name == "mirror");
    CHECK(frame.materials.at(mix.mixed[1]).plugin.type->name == "glass");
    CHECK(mix.plugin.parameters.color("amount") == Color(.1F, .2F, .3F));
    CHECK(mix.plugin.parameters.arguments().size() == 1);
}

TEST_CASE("an undefined material of a mix is matte with the mix's parameters") {
    const Frame frame = world_with(
        "MakeNamedMaterial \"a\" \"string type\" \"glass\"\nMaterial \"mix\" \"string "
        "namedmaterial1\" \"a\" \"string namedmaterial2\" \"z\" " +
            red + sphere,
        "a.pbrt:2:1: error: no material 'z' is defined; 'matte' stands in for it");
    const Material& matte = frame.materials.at(material(frame).mixed[1]);
    CHECK(matte.plugin.type->name == "matte");
    CHECK(matte.plugin.parameters.color("Kd") == Color(1, 0, 0));
}

TEST_CASE("a shape's parameters stand in for its material's") {
    const Frame frame = good_world("Material \"plastic\" " + red + "\"float roughness\" .3 " +
                                   sphere + green + sphere);
    CHECK(diffuse(frame, 0) == Color(0, 1, 0));
    CHECK(material(frame, 0).plugin.parameters.number("roughness") == .3F);
    CHECK(diffuse(frame, 1) == Color(1, 0, 0));
    CHECK(frame.materials.size() == 2);
}

TEST_CASE("shapes that state the same material share it") {
    const Frame frame = good_world("Material \"plastic\" " + sphere + green + sphere + green +
                                   sphere + "\"float zmin\" -.5 ");
    CHECK(frame.shapes.at(0).material == frame.shapes.at(1).material);
    CHECK(frame.materials.size() == 2);
    CHECK(frame.shapes.at(2).plugin.parameters.number("zmin") == -.5F);
}

TEST_CASE("a shape can give its material a texture, and replace one by a value") {
    const Frame frame =
        good_world("Texture \"t\" \"color\" \"constant\" Material \"matte\" \"texture Kd\" \"t\" " +
                   sphere + red + "Material \"matte\" " + red + sphere + "\"texture Kd\" \"t\"");
    CHECK(diffuse(frame, 0) == Color(1, 0, 0));
    CHECK_FALSE(material(frame, 0).plugin.parameters.texture("Kd"));
    CHECK(material(frame, 1).plugin.parameters.texture("Kd") == 0U);
}

TEST_CASE("a texture of a shape that is not defined hides its material's value") {
    const std::string text = "Material \"matte\" " + red + "\n" + sphere + "\"texture Kd\" \"t\"";
    const Frame frame =
        world_with(text, "a.pbrt:2:16: error: no spectrum texture 't' is defined for 'Kd'");
    CHECK(diffuse(frame) == Color(0.5F));
}

TEST_CASE("a shape that states its material anew takes the textures that are known then") {
    const std::string text =
        "Texture \"t\" \"color\" \"constant\" Material \"matte\" \"texture Kd\" \"t\" " + sphere +
        "\nTexture \"t\" \"color\" \"checkerboard\" " + sphere + sphere + "\"float sigma\" 3";
    const Frame frame =
        world_with(text, "a.pbrt:2:1: warning: the spectrum texture 't' is defined again");
    CHECK(material(frame, 0).plugin.parameters.texture("Kd") == 0U);
    CHECK(material(frame, 1).plugin.parameters.texture("Kd") == 0U);
    CHECK(material(frame, 2).plugin.parameters.texture("Kd") == 1U);
}

TEST_CASE("what tells pbrt-v3 that a shape states a material") {
    // A material whose texture is redefined shows whether the material was created again.
    const std::string before =
        "Texture \"t\" \"color\" \"constant\" Material \"matte\" \"texture Kd\" "
        "\"t\"\nTexture \"t\" \"color\" \"constant\" Texture \"f\" \"float\" "
        "\"constant\" Shape ";
    const auto is_anew = [&](const std::string& shape) {
        const Frame frame = parse_world(before + shape).frames.at(0);
        return *material(frame).plugin.parameters.texture("Kd") == 1;
    };
    CHECK_FALSE(is_anew("\"sphere\""));
    CHECK_FALSE(is_anew("\"sphere\" \"float radius\" 2"));
    CHECK(is_anew("\"sphere\" \"float zmin\" 0"));
    CHECK(is_anew("\"sphere\" \"string other\" \"x\""));
    CHECK_FALSE(is_anew("\"sphere\" \"string type\" \"x\""));
    CHECK_FALSE(is_anew("\"sphere\" \"string scheme\" \"x\""));
    CHECK_FALSE(is_anew("\"plymesh\" \"string filename\" \"x\""));
    CHECK_FALSE(is_anew("\"plymesh\" \"string filename\" \"x\" \"texture alpha\" \"f\""));
    CHECK_FALSE(is_anew("\"plymesh\" \"string filename\" \"x\" \"texture shadowalpha\" \"f\""));
    CHECK(is_anew("\"plymesh\" \"string filename\" \"x\" \"texture sigma\" \"f\""));
    CHECK(is_anew("\"sphere\" \"bool discarddegenerateUVs\" \"true\""));
    CHECK(is_anew("\"sphere\" \"integer i\" 1"));
    CHECK_FALSE(is_anew("\"sphere\" \"integer i\" [1 2]"));
    CHECK(is_anew("\"sphere\" \"point p\" [1 2 3]"));
    CHECK_FALSE(is_anew("\"sphere\" \"point p\" [1 2 3 4 5 6]"));
    CHECK(is_anew("\"sphere\" \"normal n\" [1 2 3]"));
    CHECK(is_anew("\"sphere\" \"rgb c\" [1 2 3]"));
}

TEST_CASE("a parameter that neither the shape nor its material has is not used") {
    const ParsedFile file = parse_world("Material \"matte\" " + sphere + "\"float sigmo\" 3");
    CHECK(messages(file) == Messages{"a.pbrt:1:44: warning: 'sigmo' is not used: the shape "
                                     "'sphere' has no such parameter"});
}

TEST_CASE("the index of refraction has two names") {
    const auto eta = [](const std::string& parameters) {
        return material(parse_world("Material \"glass\" " + parameters + sphere).frames.at(0))
            .plugin.parameters.number("eta");
    };
    CHECK(eta("") == 1.5F);
    CHECK(eta("\"float eta\" 2 ") == 2);
    CHECK(eta("\"float index\" 3 ") == 3);
    CHECK(eta("\"float index\" 3 \"float eta\" 2 ") == 2);
    CHECK(eta("\"float index\" 3 \"texture eta\" \"undefined\" ") == 3);
}

TEST_CASE("a material takes the first of several values") {
    const Frame frame =
        world_with("Material \"matte\" \"rgb Kd\" [1 0 0 0 1 0] " + sphere,
                   "a.pbrt:1:29: warning: 'Kd' takes one value; 1 more are ignored");
    CHECK(diffuse(frame) == Color(1, 0, 0));
}

TEST_CASE("a number is no colour and a colour is no number") {
    const Frame frame = world_with("Material \"matte\" \"float Kd\" 1 " + sphere,
                                   "a.pbrt:1:29: warning: 'float Kd' is not used: in the material "
                                   "'matte' its type is rgb or texture");
    CHECK(diffuse(frame) == Color(0.5F));
    world_with("Material \"matte\" \"rgb sigma\" [1 1 1] ",
               "a.pbrt:1:29: warning: 'rgb sigma' is not used: in the material 'matte' its type is "
               "float or texture");
}
