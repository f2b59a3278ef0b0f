// Loading of files, and detection of formats.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "core/numerics/random.h"
#include "tests/catch.h"
#include "tests/formats/nff_text.h"
#include "tests/formats/p3f_text.h"
#include "tests/formats/whole_scenes.h"

using namespace etalon;

namespace {

namespace fs = std::filesystem;

/// A file that is removed at the end of the test.
struct ScratchFile {
    ScratchFile(const std::string& name, const std::string& content)
        : path((fs::temp_directory_path() / ("etalon_" + name)).string()) {
        std::ofstream(path, std::ios::binary) << content;
    }
    ~ScratchFile() { fs::remove(path); }
    std::string path;
};

std::string only_message(const LoadResult& r) {
    CHECK_FALSE(r.scene);
    REQUIRE(r.diagnostics.size() == 1);
    return to_string(r.diagnostics[0]);
}

std::string foreign(const std::string& text, const std::string& name = "f") {
    return only_message(load_scene_text(text, name));
}

std::string joined_names() {
    std::string list;
    for (const std::string_view name : format_names()) {
        list += (list.empty() ? "" : ", ") + std::string(name);
    }
    return list;
}

const std::string reads = "; Etalon reads: " + joined_names();

std::string looks_like(const std::string& what) {
    return "f: error: this looks like " + what + reads;
}

}  // namespace

TEST_CASE("a scene file is read") {
    const ScratchFile file("good.p3f", good_camera + good_material + "s 0 0 0 1");
    const LoadResult r = load_scene(file.path);
    CHECK(messages(r).empty());
    REQUIRE(r.scene);
    CHECK(r.scene->geometry.primitives.size() == 1);
}

TEST_CASE("a file larger than one read comes whole") {
    std::string text = good_camera + good_material;
    for (int i = 0; i < 50000; ++i) text += "s 0 0 0 1\n";
    const ScratchFile file("large.p3f", text);
    CHECK(load_scene(file.path).scene->geometry.primitives.size() == 50000);
}

TEST_CASE("- is standard input") {
    std::string text = good_camera + good_material;
    for (int i = 0; i < 50000; ++i) text += "s 0 0 0 1\n";
    const ScratchFile file("stdin", text);
    REQUIRE(std::freopen(file.path.c_str(), "rb", stdin));
    LoadOptions options;
    options.format = "p3f";
    const LoadResult r = load_scene("-", options);
    REQUIRE(r.scene);
    CHECK(r.scene->geometry.primitives.size() == 50000);
}

TEST_CASE("an unreadable file is an error") {
    const std::string directory = fs::temp_directory_path().string();
    CHECK(only_message(load_scene(directory)) == directory + ": error: is a directory");
    CHECK(only_message(load_scene("/no/such.p3f")) ==
          "/no/such.p3f: error: cannot be opened: No such file or directory");
    CHECK_THAT(only_message(load_scene("/proc/self/mem")), ContainsSubstring("cannot be read: "));
}

TEST_CASE("a file too large to be a scene is not even read") {
    const ScratchFile file("sparse.p3f", "s");
    fs::resize_file(file.path, std::uintmax_t{1} << 42);
    CHECK(only_message(load_scene(file.path)) == file.path + ": error: is larger than 16 GiB");
}

TEST_CASE("an empty file is an error") {
    const ScratchFile file("empty.p3f", "");
    CHECK(only_message(load_scene(file.path)) == file.path + ": error: the file is empty");
}

TEST_CASE("a file of nothing but comments has no camera") {
    CHECK(foreign("# nothing\n", "f.p3f") ==
          "f.p3f:2:1: error: no camera, so nothing can be rendered");
}

TEST_CASE("a format is detected by the content rather than by the extension") {
    CHECK(load_scene_text(good_camera, "f").scene);
    CHECK(load_scene_text(good_camera, "f.nff").scene);
    CHECK(load_scene_text("v from 0 0 1 at 0 0 0 up 0 1 0 angle 45 resolution 4 4", "f.p3f").scene);
    CHECK(foreign("v from 0 0 1 at 0 0 0 up 0 1 0 angle 45 resolution 4 4") ==
          "f: error: no format recognised" + reads);
}

TEST_CASE("scenes of every format that is read are recognised by their content") {
    for (const WholeScene& scene : whole_scenes()) {
        const LoadResult r = load_scene_text(scene.text, "f");
        REQUIRE(r.scene);
        CHECK(r.scene->format == scene.format);
    }
    CHECK(load_scene_text("l 1 2 3\nf 1 1 1 1 0 1 0 1\n" + good_view, "f").scene->format == "nff");
    CHECK(load_scene_text(good_view, "f.nff").scene->format == "nff");
}

TEST_CASE("scenes of other formats are recognised and named") {
    CHECK(foreign("LookAt 0 0 1 0 0 0 0 1 0\nColorSpace \"srgb\"\nWorldBegin\n") ==
          looks_like("a PBRT scene of version 4"));
    CHECK(foreign("# cube\nmtllib a.mtl\nv 0 0 0\nv 1 0 0\nf 1 2 3\n") ==
          looks_like("a Wavefront OBJ mesh"));
}

TEST_CASE("SCE is recognised by any of its statements that make an image") {
    const std::string background = "background 1 1 1\n";
    for (const char* statement :
         {"nx 64", "max_recursion 2", "cr 1 0 0", "ball 1 0 0 -5", "cylinder",
          "triangle 0 0 -5 1 0 -5 0 1 -5", "pointlight 0 0 0 1 1 1", "arealight 1 1 1 1",
          "object_flat none.obj"}) {
        CAPTURE(statement);
        CHECK(format_of(background + statement + "\nend\n", "f", {}) == "sce");
    }
    CHECK(format_of(background + "resolution 4 4\nlight 0 0 0\n", "f", {}) == "prt");
}

TEST_CASE("a name in a scene that is a keyword of another format does not tell the format") {
    const std::string pbrt =
        "WorldBegin\nMakeNamedMaterial \"a cylinder #1\" \"string type\" "
        "\"matte\"\nShape \"plymesh\" \"string filename\" [\"an Option "
        "spp.ply\"]\nWorldEnd\n";
    const std::string prt = "instance cylinder\nsphere 0 0 0 1\nend_instance\ninstance_of camera\n";
    const std::string p3f = good_camera + "env object_flat\n";
    const std::string sce = "object_flat camera\nobject_phong punctual\n";
    for (const std::string name : {"f", "f.sce", "f.pbrt", "f.p3f", "f.prt"}) {
        CAPTURE(name);
        CHECK(format_of(pbrt, name, {}) == "pbrt");
        CHECK(format_of(prt, name, {}) == "prt");
        CHECK(format_of(p3f, name, {}) == "p3f");
        CHECK(format_of(sce, name, {}) == "sce");
    }
}

TEST_CASE("the extension tells which of several formats that a text shows is meant") {
    const std::string text = "background 1 1 1\ncylinder\nspp 4\n";
    CHECK(format_of(text, "f", {}) == "sce");
    CHECK(format_of(text, "f.prt", {}) == "prt");
    CHECK(format_of(text, "f.p3f", {}) == "p3f");
    CHECK(format_of(text, "f.nff", {}) == "sce");
    CHECK(foreign("o cylinder\nv 0 0 0\n", "f.obj") ==
          "f.obj: error: this looks like a Wavefront OBJ mesh" + reads);
    CHECK(format_of("l 1 2 3\nbclr 1 1 1\n", "f.nff", {}) == "p3f");
}

TEST_CASE("names of version 4 tell a PBRT scene's version only in their place") {
    const auto format = [](const std::string& options) {
        return format_of(options + "\nWorldBegin\nWorldEnd\n", "f", {});
    };
    CHECK(format("MakeNamedMaterial \"rgb\" \"string type\" \"matte\"") == "pbrt");
    CHECK(format("MakeNamedMedium \"zsobol\"") == "pbrt");
    CHECK(foreign("Film \"rgb\"\nWorldBegin\n") == looks_like("a PBRT scene of version 4"));
    CHECK(foreign("Sampler \"zsobol\" \"integer pixelsamples\" 4\nWorldBegin\n") ==
          looks_like("a PBRT scene of version 4"));
}

TEST_CASE("a scene of another format is named by its extension where it shows nothing") {
    CHECK(foreign("s 0 0 0 1", "f.obj") ==
          "f.obj: error: this looks like a Wavefront OBJ mesh" + reads);
}

TEST_CASE("a binary file is named so") {
    Random random(6);
    std::string text(5000, ' ');
    for (char& c : text) c = static_cast<char>(random.bits());
    CHECK(foreign(text) == looks_like("a binary file"));
    CHECK(foreign(std::string("\x76\x2f\x31\x01\x02\0\0\0channels\0chlist\0", 24)) ==
          looks_like("a binary file"));
}

TEST_CASE("a requested format is used, and must exist") {
    LoadOptions options;
    options.format = "p3f";
    CHECK(load_scene_text("b 1 1 1\n" + good_camera, "f", options).scene);
    options.format = "P3D";
    CHECK(only_message(load_scene_text(good_camera, "f", options)) ==
          "f: error: unknown format 'P3D'" + reads + "; did you mean 'p3f'?");
    options.format = "obj";
    CHECK(only_message(load_scene_text(good_camera, "f", options)) ==
          "f: error: unknown format 'obj'" + reads);
}

TEST_CASE("the formats that can be read are listed") {
    CHECK(std::ranges::count(format_names(), "p3f") == 1);
    CHECK(std::ranges::count(format_names(), "obj") == 0);  // meshes are no scenes
}
