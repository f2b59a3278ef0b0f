#include "core/formats/load.h"
#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

const Parameters& material(const Frame& frame, std::size_t shape = 0) {
    return frame.materials.at(frame.shapes.at(shape).material).plugin.parameters;
}

const std::string sphere = "Shape \"sphere\" ";

}  // namespace

TEST_CASE("float and spectrum textures are separate, even of one name") {
    const Frame frame = good_world(
        "Texture \"t\" \"float\" \"constant\" \"float value\" 3\n"
        "Texture \"t\" \"spectrum\" \"constant\" \"rgb value\" [1 2 3]\n"
        "Material \"matte\" \"texture Kd\" \"t\" \"texture sigma\" \"t\" " +
        sphere);
    CHECK(material(frame).texture("sigma") == 0U);
    CHECK(material(frame).texture("Kd") == 1U);
    CHECK(frame.textures.at(0).plugin.type->category == Category::float_texture);
    CHECK(frame.textures.at(0).plugin.parameters.number("value") == 3);
    CHECK(frame.textures.at(1).plugin.type->category == Category::spectrum_texture);
    CHECK(frame.textures.at(1).plugin.parameters.color("value") == Color(1, 2, 3));
}

TEST_CASE("a spectrum texture may be called one of colours") {
    const Frame frame = good_world("Texture \"t\" \"color\" \"constant\"");
    CHECK(frame.textures.at(0).plugin.type->category == Category::spectrum_texture);
}

TEST_CASE("a float texture is no spectrum texture") {
    const Frame frame = world_with(
        "Texture \"t\" \"float\" \"constant\"\nMaterial \"matte\" \"texture Kd\" \"t\" " + sphere,
        "a.pbrt:2:18: error: no spectrum texture 't' is defined for 'Kd'");
    CHECK(material(frame).color("Kd") == Color(0.5F));
    CHECK_FALSE(material(frame).is_given("Kd"));
}

TEST_CASE("an undefined texture leaves the default, or nothing where there is none") {
    const Frame frame = world_with("Material \"matte\" \"texture bumpmap\" \"t\" " + sphere,
                                   "a.pbrt:1:29: error: no float texture 't' is defined for "
                                   "'bumpmap'");
    CHECK_FALSE(material(frame).is_given("bumpmap"));
    const ParsedFile near = parse_world(
        "Texture \"grid\" \"float\" \"constant\"\n"
        "Material \"matte\" \"texture sigma\" \"gird\"");
    CHECK(messages(near) == Messages{"a.pbrt:2:18: error: no float texture 'gird' is defined for "
                                     "'sigma'; did you mean 'grid'?"});
}

TEST_CASE("textures are not found before they are defined") {
    const ParsedFile file = parse_world(
        "Texture \"a\" \"float\" \"scale\" \"texture tex1\" \"b\" "
        "Texture \"b\" \"float\" \"constant\"");
    REQUIRE(file.diagnostics.size() == 1);
    CHECK(file.diagnostics[0].kind == "undefined");
}

TEST_CASE("a texture takes textures of its own type, and an amount of floats") {
    const Frame frame = good_world(
        "Texture \"s\" \"color\" \"constant\" Texture \"f\" \"float\" \"constant\"\n"
        "Texture \"m\" \"color\" \"mix\" \"texture tex1\" \"s\" \"rgb tex2\" [0 0 1] \"texture "
        "amount\" \"f\"");
    const Parameters& mix = frame.textures.at(2).plugin.parameters;
    CHECK(mix.texture("tex1") == 0U);
    CHECK(mix.color("tex2") == Color(0, 0, 1));
    CHECK(mix.texture("amount") == 1U);
}

TEST_CASE("a texture before a value of the same parameter") {
    const Frame frame = parse_world(
                            "Texture \"s\" \"color\" \"constant\" Material \"matte\" "
                            "\"rgb Kd\" [1 0 0] \"texture Kd\" \"s\" " +
                            sphere)
                            .frames.at(0);
    CHECK(material(frame).texture("Kd") == 0U);
}

TEST_CASE("a texture defined in a block vanishes at its end") {
    world_with(
        "AttributeBegin Texture \"t\" \"float\" \"constant\" AttributeEnd\n"
        "Material \"matte\" \"texture sigma\" \"t\"",
        "a.pbrt:2:18: error: no float texture 't' is defined for 'sigma'");
}

TEST_CASE("a texture of an inner block comes before one of an outer block") {
    const std::string text =
        "Texture \"t\" \"float\" \"constant\"\nAttributeBegin Texture \"t\" \"float\" \"fbm\" "
        "Material \"matte\" \"texture sigma\" \"t\" " +
        sphere + "AttributeEnd Material \"matte\" \"texture sigma\" \"t\" " + sphere;
    const Frame frame =
        world_with(text, "a.pbrt:2:16: warning: the float texture 't' is defined again");
    CHECK(material(frame, 0).texture("sigma") == 1U);
    CHECK(material(frame, 1).texture("sigma") == 0U);
}

TEST_CASE("what used a texture before it was defined again keeps the old one") {
    const Frame frame = world_with(
        "Texture \"t\" \"float\" \"constant\" Material \"matte\" \"texture sigma\" \"t\"\n"
        "Texture \"t\" \"float\" \"fbm\" " +
            sphere,
        "a.pbrt:2:1: warning: the float texture 't' is defined again");
    CHECK(material(frame).texture("sigma") == 0U);
}

TEST_CASE("a texture of an unknown class or type is not defined") {
    world_with("Texture \"t\" \"float\" \"fbn\"",
               "a.pbrt:1:12: warning: unknown float texture 'fbn'; it is not defined; did you mean "
               "'fbm'?");
    world_with("Texture \"t\" \"integer\" \"fbm\"",
               "a.pbrt:1:12: error: a texture is of type float, spectrum or color, not 'integer'");
    CHECK(parse_world("Texture \"t\" \"float\" \"marble\"").frames.at(0).textures.empty());
    CHECK(parse_world("Texture \"t\" \"float\" \"uv\"").frames.at(0).textures.empty());
}

TEST_CASE("a texture has the transformation of its place, at the start") {
    const Frame frame = good_world("Translate 1 0 0 Texture \"t\" \"float\" \"fbm\"");
    CHECK(image(frame.transforms[frame.textures.at(0).to_world], {0, 0, 0}) == Vec3(1, 0, 0));
    const Frame moving =
        world_with("ActiveTransform EndTime Translate 1 0 0\nTexture \"t\" \"float\" \"fbm\"",
                   "a.pbrt:2:1: warning: 'Texture' cannot move: it stays where it is at the start");
    CHECK(moving.textures.at(0).to_world == 0);
}

TEST_CASE("textures are sRGB by their extension in any case, unless gamma says") {
    const auto decodes = [](const std::string& file, const std::string& more = "") {
        const LoadResult loaded = load_scene_text(
            "WorldBegin\nTexture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"" + file +
                "\" " + more +
                "\nMaterial \"matte\" \"texture Kd\" \"t\" Shape \"sphere\"\nWorldEnd\n",
            "a.pbrt");
        return loaded.scene.value().physical().textures.images.at(0).decode_srgb;
    };
    for (const char* file : {"a.png", "a.Png", "a.PNG", "a.tGa", ".png"}) {
        CAPTURE(file);
        CHECK(decodes(file));
        CHECK_FALSE(decodes(file, "\"bool gamma\" \"false\""));
    }
    for (const char* file : {"a.exr", "png", "a.png.pfm", "a.pn"}) {
        CAPTURE(file);
        CHECK_FALSE(decodes(file));
        CHECK(decodes(file, "\"bool gamma\" \"true\""));
    }
}

TEST_CASE("Textures: given the same file, wrapping, decoding and scale, then they share an image") {
    const std::string texture = "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" ";
    std::string world;
    for (const char* const more :
         {"\"a.png\"", "\"a.png\" \"float scale\" 2", "\"a.png\" \"string wrap\" \"clamp\"",
          "\"b.png\"", "\"a.png\" \"bool gamma\" \"false\"", "\"a.png\" \"float uscale\" 3",
          "\"b.png\""}) {
        world += texture + more + "\nMaterial \"matte\" \"texture Kd\" \"t\" Shape \"sphere\"\n";
    }
    const LoadResult loaded = load_scene_text("WorldBegin\n" + world + "WorldEnd\n", "a.pbrt");
    const Textures& textures = loaded.scene.value().physical().textures;
    CHECK(textures.images.size() == 5);
    std::vector<std::uint32_t> numbers;
    for (const auto& t : textures.colors) numbers.push_back(std::get<ImageTexture<Color>>(t).image);
    CHECK(numbers == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 0, 3});
}
