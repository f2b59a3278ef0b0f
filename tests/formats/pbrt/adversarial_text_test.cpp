// Adversarial texts: time and memory stay in proportion to the input.
#include <algorithm>

#include "tests/formats/pbrt/pbrt_text.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

}  // namespace

TEST_CASE("blocks may be nested a hundred thousand deep") {
    const ParsedFile file = parse_world(
        repeated("AttributeBegin Translate 1 0 0 Texture \"t\" \"float\" \"constant\" ", 100'000) +
        repeated("AttributeEnd ", 100'000) + "Shape \"sphere\"");
    const Frame& frame = file.frames.at(0);
    CHECK(frame.textures.size() == 100'000);
    CHECK(frame.shapes.at(0).to_world == TransformPair{0, 0});
    CHECK(file.diagnostics.size() == 20);  // the texture is defined again
}

TEST_CASE("blocks that are never ended are said, but not all of them") {
    const ParsedFile file = parse_world(repeated("AttributeBegin TransformBegin ", 100'000));
    CHECK(file.diagnostics.size() == 20);
    CHECK(file.diagnostics.back().more == 200'000 - 20);
}

TEST_CASE("errors without end are counted") {
    for (const char* text :
         {"Shpae ", "NamedMaterial \"a\" ", "Material \"matte\" \"texture Kd\" \"x\" ", "Scale x ",
          "Shape \"cube\" ", "Shape \"sphere\" \"float radios\" 1 ", "] ", "\" \n",
          "AttributeEnd "}) {
        CAPTURE(text);
        const ParsedFile file = parse_world(repeated(text, 50'000));
        CHECK(file.diagnostics.size() <= 60);
        CHECK(file.frames.size() == 1);
    }
}

TEST_CASE("an unknown name among many names costs no more than among few") {
    std::string text;
    for (int i = 0; i < 20'000; ++i) {
        text += "Texture \"texture" + std::to_string(i) + "\" \"float\" \"constant\" ";
    }
    text += repeated("Material \"matte\" \"texture sigma\" \"textura\" ", 20'000);
    const ParsedFile file = parse_world(text);
    CHECK(file.diagnostics.size() == 20);
}

TEST_CASE("frames without end are read up to a limit") {
    const ParsedFile file = parse_text(repeated("WorldBegin WorldEnd ", 2000));
    CHECK(file.frames.size() == 1000);
    CHECK(file.diagnostics.size() == 20);
    CHECK(file.diagnostics[0].kind == "frames");
}

TEST_CASE("long tokens are read and cut where they are shown") {
    const std::string name(1'000'000, 'x');
    const ParsedFile file = parse_world("NamedMaterial \"" + name + "\" Translate 0 0 1" +
                                        std::string(1'000'000, '0') + " " + name);
    REQUIRE(file.diagnostics.size() == 3);
    for (const Diagnostic& d : file.diagnostics) CHECK(d.message.size() < 300);
}

TEST_CASE("bytes that no text has are no crash") {
    for (int byte = 0; byte < 256; ++byte) {
        const std::string c(1, static_cast<char>(byte));
        const ParsedFile file = parse_world(c + " Shape \"sphere\" " + c + " \"float radius\" " +
                                            c + "1" + c + "\"" + c);
        CHECK(file.frames.size() == 1);
    }
}

TEST_CASE("lists of many values and of none are read") {
    const ParsedFile file =
        parse_world("Shape \"trianglemesh\" \"integer indices\" [" + repeated("0 1 2 ", 100'000) +
                    "] \"point P\" [" + repeated("1e-3 -2.5 3 # comment\n", 100'000) + "]");
    CHECK(messages(file) == Messages{});
    const Parameters& mesh = file.frames.at(0).shapes.at(0).plugin.parameters;
    CHECK(mesh.integers("indices").size() == 300'000);
    CHECK(mesh.numbers("P").size() == 300'000);
    CHECK(mesh.numbers("P")[299'998] == -2.5F);
    CHECK(parse_world("Shape \"trianglemesh\" \"integer indices\" [] \"point P\" []")
              .frames.at(0)
              .shapes.empty());
}
