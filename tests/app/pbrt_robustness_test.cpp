// Malformed PBRT scenes: each error is reported with its position, and none crashes the program or
// takes time or memory out of proportion to the file.
#include <algorithm>
#include <array>
#include <string>

#include "core/image/io.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/sanitized.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// A scene whose line 7 holds `world`.
std::string scene_with(const std::string& world) {
    return "LookAt 0 1 -6 0 0.5 0 0 1 0\n"
           "Camera \"perspective\" \"float fov\" 40\n"
           "Film \"image\" \"integer xresolution\" 8 \"integer yresolution\" 6\n"
           "Sampler \"sobol\" \"integer pixelsamples\" 2\n"
           "WorldBegin\n"
           "LightSource \"infinite\" \"rgb L\" [1 1 1]\n" +
           world + "\nShape \"sphere\"\nWorldEnd\n";
}

ProgramResult rendered(const Folder& f, const std::string& scene) {
    f.write("bad.pbrt", scene);
    return f.shell("ulimit -t 20; exec " ETALON_BINARY_DIR
                   "/bin/etalon render bad.pbrt -t 1 -q -o bad.exr");
}

void check_said(const Folder& f, const std::string& world, const std::string& message) {
    INFO(world.substr(0, 200));
    const ProgramResult r = rendered(f, scene_with(world));
    CHECK(r.status == 0);
    CHECK_THAT(r.err, ContainsSubstring(message));
    // A process begins with the peak of the one that started it, which sanitizers make large.
    if (!is_sanitized) CHECK(r.peak_bytes < (1U << 28));
}

std::string mesh(const std::string& points, const std::string& indices) {
    return "Shape \"trianglemesh\" \"point P\" [" + points + "] \"integer indices\" [" + indices +
           "]";
}

const std::string grey_texture =
    "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"none.png\" "
    "Material \"matte\" \"texture Kd\" \"t\"";

std::string ply_header(const std::string& vertices, const std::string& faces) {
    return "ply\nformat binary_little_endian 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

}  // namespace

TEST_CASE("Files that a PBRT scene lacks are said at the statement that names them", "[app]") {
    const Folder f;
    check_said(f, "Include \"none\"", "bad.pbrt:7:1: error: 'none' cannot be opened");
    check_said(f, "Include \"bad.pbrt\"", "bad.pbrt:7:1: error: 'bad.pbrt' is not included");
    check_said(f, "Include \"../../../none/..\"", "bad.pbrt:7:1: error: ");
    check_said(f, "Shape \"plymesh\" \"string filename\" \"none.ply\"",
               "bad.pbrt:7:1: warning: \"plymesh\" left out: none.ply: cannot be opened");
    check_said(f, "Shape \"plymesh\" \"string filename\" \"/dev/zero\"",
               "bad.pbrt:7:1: warning: \"plymesh\" left out: /dev/zero: is a pipe or device");
    check_said(f, grey_texture,
               "bad.pbrt:7:1: warning: none.png: cannot be read: No such file or directory; grey "
               "stands in");
    check_said(
        f, "LightSource \"infinite\" \"string mapname\" \"none.exr\"",
        "bad.pbrt:7:1: warning: none.exr: cannot be read: No such file or directory; a light "
        "without an image stands in");
    check_said(f, "Material \"metal\" \"spectrum eta\" \"none.spd\"", "bad.pbrt:7:18: warning: ");
}

TEST_CASE("Every statement that names an image that cannot be read is said", "[app]") {
    const Folder f;
    const std::string world = "LightSource \"infinite\" \"string mapname\" \"none.png\"\n" +
                              grey_texture +
                              "\nTexture \"t\" \"float\" \"imagemap\" \"string filename\" "
                              "\"none.png\"";
    check_said(f, world, "bad.pbrt:7:1: warning: none.png: cannot be read: No such file");
    check_said(f, world, "bad.pbrt:8:1: warning: none.png: cannot be read: No such file");
    check_said(f, world, "bad.pbrt:9:1: warning: none.png: cannot be read: No such file");
    check_said(f, "Texture \"t\" \"spectrum\" \"imagemap\"",
               "bad.pbrt:7:1: warning: 'filename' is missing; grey stands in");
    std::string textures;
    for (int i = 0; i < 30; ++i) textures += grey_texture + "\n";
    check_said(f, textures, "bad.pbrt: warning: 10 more of this kind (image)");
}

TEST_CASE("Names in a PBRT scene neither control a terminal nor forge a message", "[app]") {
    const Folder f;
    const std::string escape = "\x1B[31m", name = "a\\nb.pbrt:1:1: error: c\\b" + escape;
    const ProgramResult r =
        rendered(f, scene_with("LightSource \"infinite\" \"string mapname\" \"" + name + "\"\n" +
                               "Texture \"" + escape +
                               "\" \"spectrum\" \"imagemap\" \"string filename\" \"" + name +
                               "\"\nMaterial \"matte\" \"texture Kd\" \"" + escape +
                               "0\"\nShape \"plymesh\" \"string filename\" \"" + name + "\""));
    CHECK(r.err.find_first_of("\x1B\b") == std::string::npos);
    CHECK(std::count(r.err.begin(), r.err.end(), '\n') == 4);
    CHECK_THAT(r.err, ContainsSubstring("bad.pbrt:7:1: warning: a\\x0ab.pbrt:1:1: error: c\\x08"));
}

TEST_CASE("An image of no pixels, or of more than there are, is replaced by grey", "[app]") {
    const Folder f;
    const std::string nothing("\0\0\0\0\0\0\0\0", 8), most("\x7F\xFF\xFF\xFF\x7F\xFF\xFF\xFF");
    for (const std::string& size : {nothing, most}) {
        std::string png("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16);
        png += size;
        png.append("\x08\x02\0\0\0abcd", 9);
        f.write("none.png", png);
        check_said(f, grey_texture, "bad.pbrt:7:1: warning: none.png: cannot be read: the PNG is ");
    }
    f.write("none.png", "");
    check_said(f, grey_texture, "none.png: cannot be read: the file is empty; grey stands in");
}

TEST_CASE("Numbers of PBRT scenes that cannot be are said where they stand", "[app]") {
    const Folder f;
    check_said(f, mesh("0 0 0 1 0 0 0 nan 0", "0 1 2"), "bad.pbrt:7:47: error: a number of 'P'");
    check_said(f, mesh("0 0 0 1 0 0 0 1e400 0", "0 1 2"), "bad.pbrt:7:47: error: a number of 'P'");
    check_said(f, mesh("0 0 0 1 0 0 0 1 0", "0 1 1000000000"),
               "bad.pbrt:7:1: warning: \"trianglemesh\" left out: there is no vertex 1000000000");
    check_said(f, mesh("0 0 0 1 0 0 0 1 0", "0 1 -1"), "there is no vertex -1");
    check_said(f, "Shape \"sphere\" \"float radius\" -inf", "bad.pbrt:7:31: error: ");
    check_said(f,
               "Shape \"loopsubdiv\" \"integer nlevels\" 30 \"point P\" [0 0 0 1 0 0 0 1 0] "
               "\"integer indices\" [0 1 2]",
               "bad.pbrt:7:1: warning: \"loopsubdiv\" left out: ");
    check_said(f, "ObjectBegin \"a\" ObjectInstance \"a\" ObjectEnd", "bad.pbrt:7:17: error: ");
    std::string blocks;
    for (int i = 0; i < 100'000; ++i) blocks += "AttributeBegin ";
    check_said(f, blocks, "bad.pbrt:7:1: warning: this block is not ended");
}

TEST_CASE("A PLY that claims more than it holds is refused before room is made", "[app]") {
    const Folder f;
    const std::string shape = "Shape \"plymesh\" \"string filename\" \"a.ply\"";
    const std::string zeros(200, '\0');
    for (const auto& [vertices, faces] :
         {std::array{"4000000000", "1"}, std::array{"2000000000", "1"},
          std::array{"3", "4000000000"}, std::array{"-1", "1"},
          std::array{"99999999999999999999", "1"}}) {
        f.write("a.ply", ply_header(vertices, faces) + zeros);
        check_said(f, shape, "a.ply:");
        check_said(f, shape, "bad.pbrt:7:1: warning: \"plymesh\" left out: a.ply cannot be read");
    }
}

TEST_CASE("Films and samples beyond all machines are cut down with a warning", "[app]") {
    const Folder f;
    std::string film = scene_with("");
    film.replace(film.find("\"integer xresolution\" 8"), 23, "\"integer xresolution\" 1000000");
    const ProgramResult r = rendered(f, film);
    CHECK(r.status == 0);
    CHECK_THAT(r.err,
               ContainsSubstring("bad.pbrt:3:1: warning: resolution 1000000: expected 1 to"));
    for (const std::string samples : {"-1", "2000000000"}) {
        std::string text = scene_with("");
        text.replace(text.find("pixelsamples\" 2"), 15, "pixelsamples\" " + samples);
        f.write("bad.pbrt", text);
        const ProgramResult many = f.etalon("render bad.pbrt --spp 1 -q -o bad.exr");
        CHECK(many.status == 0);
        CHECK_THAT(many.err, ContainsSubstring("bad.pbrt:4:1: warning: " + samples +
                                               " samples a pixel: expected 1 to "));
    }
}

TEST_CASE("Samples that are not finite count as black, alike by every backend and thread",
          "[app]") {
    const Folder f;
    std::string text = scene_with("LightSource \"infinite\" \"rgb L\" [1000 1000 1000]");
    text.replace(text.find("Film \"image\""), 12, "Film \"image\" \"float scale\" 1e38");
    f.write("bright.pbrt", text);
    for (const std::string options :
         {"-b bvh -t 1", "-b bvh -t 2", "-b grid -t 1", "-b none -t 2"}) {
        INFO(options);
        const ProgramResult r =
            f.etalon("render bright.pbrt -q --spp 4 -o a.exr --stats s.json " + options);
        CHECK(r.status == 0);
        CHECK(r.err ==
              "bright.pbrt: warning: 192 samples are infinite or no number: they count as black\n");
        CHECK_THAT(f.read("s.json"), ContainsSubstring("\"dropped_samples\": 192,"));
        CHECK(f.etalon("compare a.exr a.exr").out.find("nan") == std::string::npos);
    }
}

TEST_CASE("Samples that are not finite are said with the images that have such values", "[app]") {
    const Folder f;
    RenderedImage image{2, 1, {{0, 0}, {1, 0}}, {Color(1.0F), Color(infinity)}, false, {}};
    REQUIRE(write_image(f.path("bright.exr"), image) == "");
    image.pixels[1] = Color(2.0F);
    REQUIRE(write_image(f.path("good.exr"), image) == "");
    const auto texture = [](const std::string& file) {
        return "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"" + file +
               "\" Material \"matte\" \"texture Kd\" \"t\"\n";
    };
    check_said(f, texture("good.exr") + texture("bright.exr"),
               " count as black; there are such values in bright.exr\n");
}

TEST_CASE("info shows the field of view of PBRT cameras", "[app]") {
    const Folder f;
    f.write("a.pbrt", scene_with(""));
    const ProgramResult r = f.etalon("info a.pbrt --json");
    CHECK_THAT(r.out, ContainsSubstring("\"projection\": \"perspective\""));
    CHECK_THAT(r.out, ContainsSubstring("\"fov_degrees\": 40.0"));  // the shorter side's
    std::string text = scene_with("");
    text.replace(text.find("\"perspective\""), 13, "\"environment\"");
    f.write("b.pbrt", text);
    const ProgramResult environment = f.etalon("info b.pbrt --json");
    CHECK_THAT(environment.out, ContainsSubstring("\"projection\": \"environment\""));
    CHECK_THAT(environment.out, ContainsSubstring("\"fov_degrees\": 180"));
}

TEST_CASE("A pipe that a PBRT scene names is not waited for", "[app]") {
    const Folder f;
    f.shell("mkfifo pipe.ply");
    const char* worlds[] = {R"(Include "pipe.ply")",
                            R"(Shape "plymesh" "string filename" "pipe.ply")",
                            R"(Material "fourier" "string bsdffile" "pipe.ply")",
                            R"(Material "matte" "spectrum Kd" "pipe.ply")",
                            R"(Texture "t" "spectrum" "imagemap" "string filename" "pipe.ply")"};
    for (const char* world : worlds) {
        INFO(world);
        f.write("bad.pbrt", scene_with(world));
        const auto r = f.shell("timeout -s KILL 30 " ETALON_BINARY_DIR
                               "/bin/etalon render bad.pbrt -t 1 -q -o bad.exr");
        CHECK((r.status == 0 || r.status == 3));
        CHECK_THAT(r.err, ContainsSubstring("a pipe or device; expected a file"));
    }
}
