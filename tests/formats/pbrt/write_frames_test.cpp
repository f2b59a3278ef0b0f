#include "core/formats/pbrt/write_frames.h"

#include "core/numerics/random.h"
#include "tests/formats/pbrt/pbrt_text.h"
#include "tests/formats/pbrt/same_frame.h"
#include "tests/formats/pbrt/whole_files.h"

using namespace etalon;
using namespace etalon::pbrt;

namespace {

std::string written(const ParsedFile& file, const std::string& directory = "") {
    std::string text;
    write_frames(file.frames, directory, [&](std::string_view piece) { text += piece; });
    return text;
}

/// Checks that a text, read and written, is read as the same frames, without diagnostics.
void check_round_trip(const std::string& text) {
    const ParsedFile file = parse_text(text);
    const std::string anew = written(file);
    const ParsedFile again = parse_text(anew);
    CAPTURE(text, anew);
    if (file.frames.empty()) return;
    CHECK(messages(again) == Messages{});
    REQUIRE(again.frames.size() == file.frames.size());
    for (std::size_t i = 0; i < file.frames.size(); ++i) {
        CHECK(difference(file.frames[i], again.frames[i]) == "");
    }
    CHECK(written(again) == anew);
}

void check_world(const std::string& world) {
    check_round_trip("WorldBegin " + world + " WorldEnd");
}

}  // namespace

TEST_CASE("a frame is written in one order and one spelling") {
    const ParsedFile file = parse_text(
        "Camera \"perspective\" \"float fov\" 30 WorldBegin\n"
        "AttributeBegin Texture \"c\" \"color\" \"checkerboard\" \"float uscale\" 4\n"
        "Material \"matte\" \"texture Kd\" \"c\" Translate 1 2 3 Shape \"sphere\" AttributeEnd\n"
        "WorldEnd");
    CHECK(
        written(file) ==
        "Transform [ 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 ]\n"
        "Camera \"perspective\" \"float fov\" [ 30 ]\n"
        "Sampler \"halton\"\n"
        "PixelFilter \"box\"\n"
        "Film \"image\"\n"
        "Integrator \"path\"\n"
        "Accelerator \"bvh\"\n"
        "\n"
        "WorldBegin\n"
        "Texture \"texture-0\" \"spectrum\" \"checkerboard\" \"float uscale\" [ 4 ]\n"
        "MakeNamedMaterial \"material-0\" \"string type\" \"matte\" \"texture Kd\" \"texture-0\"\n"
        "Transform [ 1 0 0 0 0 1 0 0 0 0 1 0 1 2 3 1 ]\n"
        "NamedMaterial \"material-0\"\n"
        "Shape \"sphere\"\n"
        "WorldEnd\n");
}

TEST_CASE("what is written is read as the same frames") {
    for (const std::string& text : whole_files()) check_round_trip(text);
}

TEST_CASE("what is written of a damaged file is read as the same frames") {
    Random random(9);
    for (const std::string& text : whole_files()) {
        for (int i = 0; i < 500; ++i) {
            std::string damaged = text;
            damaged[random.index(damaged.size())] = static_cast<char>(random.index(256));
            check_round_trip(damaged);
        }
    }
}

TEST_CASE("options and the camera's place are the same when read again") {
    check_round_trip(
        "LookAt 1.1 2.3 3.7 0 .1 0 0 1 .2 Camera \"orthographic\" TransformTimes .5 2 "
        "WorldBegin WorldEnd");
    check_round_trip(
        "ActiveTransform EndTime Rotate 33 1 2 3 Camera \"perspective\" WorldBegin "
        "WorldEnd");
    check_round_trip(
        "Film \"image\" \"float maxsampleluminance\" inf \"string filename\" \"a\\\\b\\\"c\" "
        "\"integer xresolution\" 5 WorldBegin WorldEnd");
    check_round_trip(
        "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" MediumInterface \"\" \"m\" "
        "Camera \"perspective\" WorldBegin WorldEnd");
}

TEST_CASE("numbers are the same when read again") {
    check_world(
        "Shape \"sphere\" \"float radius\" 0.1 \"float zmin\" -1e-30 \"float zmax\" 3.4e38");
    check_world("Rotate 33 1 2 3 Scale .1 .2 .3 Shape \"sphere\"");
    check_world("LightSource \"point\" \"blackbody I\" [3000 1.5] \"xyz scale\" [.1 .2 .3]");
}

TEST_CASE("shapes are the same when read again, whatever state they met") {
    check_world(
        "AreaLightSource \"diffuse\" \"rgb L\" [1 2 3] Shape \"sphere\" ReverseOrientation "
        "Material \"glass\" Shape \"sphere\" Translate 1 0 0 Shape \"disk\" AreaLightSource "
        "\"\" Shape \"disk\"");
    check_world(
        "AreaLightSource \"diffuse\" Shape \"sphere\" AttributeBegin AreaLightSource "
        "\"diffuse\" \"bool twosided\" \"true\" Shape \"disk\" AttributeEnd Shape \"disk\"");
    check_world(
        "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 0 0 0 1 0] "
        "\"float st\" [0 0 1 0 0 1] \"float alpha\" 0");
    check_world("Shape \"curve\" \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0] \"float splitdepth\" 4");
}

TEST_CASE("materials and textures are the same when read again") {
    check_world(
        "Texture \"t\" \"float\" \"fbm\" Texture \"t\" \"color\" \"mix\" \"texture amount\" \"t\" "
        "MakeNamedMaterial \"a\" \"string type\" \"uber\" \"texture Kd\" \"t\" \"texture "
        "bumpmap\" \"t\" Material \"mix\" \"string namedmaterial1\" \"a\" \"string "
        "namedmaterial2\" \"b\" Shape \"sphere\" Material \"\" Shape \"sphere\" \"rgb Kd\" [1 1 "
        "1]");
}

TEST_CASE("objects and instances are the same when read again") {
    check_world(
        "ObjectBegin \"o\" Material \"glass\" Shape \"sphere\" ObjectEnd Translate 1 0 0 "
        "ObjectInstance \"o\" ObjectBegin \"o\" ObjectEnd ObjectBegin \"o\" ReverseOrientation "
        "Shape \"disk\" ObjectEnd ActiveTransform EndTime Scale 2 2 2 ObjectInstance \"o\"");
}

TEST_CASE("long lists are broken into lines") {
    std::string list;
    for (int i = 0; i < 100; ++i) list += std::to_string(i) + " 0 0 ";
    const std::string text = "WorldBegin Shape \"curve\" \"point P\" [ " + list + "] WorldEnd";
    check_round_trip(text);
    CHECK(written(parse_text(text)).find("0 0 0 1 0 0 2 0 0 3 0 0 4 0 0 5 0 0\n6 0 0") !=
          std::string::npos);
}

TEST_CASE("files are named from where the text will be") {
    const ParsedFile file =
        parse("WorldBegin Shape \"plymesh\" \"string filename\" \"m/a.ply\" WorldEnd", "x/a.pbrt");
    CHECK(written(file, "").find("\"string filename\" \"x/m/a.ply\"") != std::string::npos);
    CHECK(written(file, "x").find("\"string filename\" \"m/a.ply\"") != std::string::npos);
    CHECK(written(file, "y").find("\"string filename\" \"../x/m/a.ply\"") != std::string::npos);
    const ParsedFile absolute =
        parse("WorldBegin Shape \"plymesh\" \"string filename\" \"/m/a.ply\" WorldEnd", "x/a.pbrt");
    CHECK(written(absolute, "y").find("\"string filename\" \"/m/a.ply\"") != std::string::npos);
}
