// accel, spp, bclr, env, and the defaults of a scene without them.
#include <filesystem>
#include <fstream>

#include "tests/catch.h"
#include "tests/formats/p3f_text.h"

using namespace etalon;

namespace {

namespace fs = std::filesystem;

/// A directory that is removed at the end of the test.
struct Scratch {
    explicit Scratch(const std::string& name) : path(fs::temp_directory_path() / name) {
        fs::remove_all(path);
        fs::create_directories(path);
    }
    ~Scratch() { fs::remove_all(path); }
    fs::path path;
};

void make_faces(const fs::path& directory, const std::vector<std::string>& files) {
    fs::create_directories(directory);
    for (const std::string& file : files) std::ofstream(directory / file) << "x";
}

std::vector<std::string> faces(const std::string& extension) {
    return {"right" + extension,  "left" + extension,  "top" + extension,
            "bottom" + extension, "front" + extension, "back" + extension};
}

LoadResult load_beside(const fs::path& directory, const std::string& text,
                       LoadOptions options = {}) {
    options.format = "p3f";
    return load_scene_text(text + "\n" + good_camera, (directory / "a.p3f").string(), options);
}

}  // namespace

TEST_CASE("a scene with nothing but a camera has the format's defaults") {
    const LoadResult r = load_statements("");
    CHECK(messages(r).empty());
    REQUIRE(r.scene);
    CHECK(r.scene->format == "p3f");
    CHECK(r.settings.backend.empty());
    CHECK(r.settings.samples_per_pixel == 0);
    CHECK(r.scene->whitted().environment.background == Color(0.0F));
    CHECK_FALSE(r.scene->whitted().environment.skybox);
    CHECK(r.settings.display_colors);
    CHECK(r.settings.max_depth == 5);
    CHECK_FALSE(r.settings.whitted.schlick);
    CHECK_FALSE(r.settings.whitted.clamp_each_ray);
    CHECK(r.settings.whitted.fixed_bias == 0);
}

TEST_CASE("accel is a name, or a number of the old dialect") {
    CHECK(load_statements("accel none").settings.backend == "none");
    CHECK(load_statements("accel grid").settings.backend == "grid");
    CHECK(load_statements("accel bvh").settings.backend == "bvh");
    CHECK(load_statements("accel 0").settings.backend == "none");
    CHECK(load_statements("accel 1").settings.backend == "grid");
    CHECK(load_statements("accel 2").settings.backend == "bvh");
}

TEST_CASE("an unknown accel is reported with the nearest known one") {
    const LoadResult r = load_statements("accel bhv\nspp 3");
    CHECK(messages(r) ==
          Messages{"a.p3f:1:7: warning: expected none, grid or bvh (or 0, 1, 2) after "
                   "'accel', found 'bhv'; did you mean 'bvh'?"});
    REQUIRE(r.scene);
    CHECK(r.settings.backend.empty());
    CHECK(r.settings.samples_per_pixel == 3);
}

TEST_CASE("spp is a count of samples") {
    CHECK(load_statements("spp 16").settings.samples_per_pixel == 16);
    const LoadResult negative = load_statements("spp -1");
    CHECK(messages(negative) ==
          Messages{"a.p3f:1:5: warning: expected 0 to 1048576 samples per pixel, "
                   "found -1"});
    CHECK(negative.settings.samples_per_pixel == 0);
    CHECK(load_statements("spp 99999999999").settings.samples_per_pixel == 0);
    CHECK(messages(load_statements("spp 4.5")) ==
          Messages{
              "a.p3f:1:5: warning: expected a whole number for the samples of 'spp', found '4.5'"});
}

TEST_CASE("bclr is the background") {
    CHECK(load_statements("bclr 0.25 0.5 2").scene->whitted().environment.background ==
          Color(0.25F, 0.5F, 2));
    const LoadResult r = load_statements("bclr 0 1e300 0");
    CHECK(messages(r) ==
          Messages{"a.p3f:1:8: warning: the colour of 'bclr' is too large for a colour"});
    CHECK(r.scene->whitted().environment.background == Color(0.0F));
}

TEST_CASE("env is found beside the scene file, in any of four kinds of file") {
    const Scratch scratch("etalon_env_beside");
    for (const char* extension : {".jpg", ".png", ".exr", ".hdr"}) {
        const fs::path sky = scratch.path / ("sky" + std::string(extension + 1));
        make_faces(sky, faces(extension));
        const LoadResult r = load_beside(scratch.path, "env " + sky.filename().string());
        CHECK(messages(r).empty());
        REQUIRE(r.scene->whitted().environment.skybox);
        CHECK(r.scene->whitted().environment.skybox->faces[0] ==
              (sky / ("right" + std::string(extension))).string());
        CHECK(r.scene->whitted().environment.skybox->faces[5] ==
              (sky / ("back" + std::string(extension))).string());
        CHECK_FALSE(r.scene->whitted().environment.skybox->nearest);
    }
}

TEST_CASE("env is found in the working directory where the scene file has none beside it") {
    const Scratch scratch("etalon_env_working");
    make_faces(scratch.path / "sky", faces(".png"));
    const fs::path before = fs::current_path();
    fs::current_path(scratch.path);
    const LoadResult r = load_beside("/nowhere", "env sky");
    fs::current_path(before);
    REQUIRE(r.scene->whitted().environment.skybox);
    CHECK(r.scene->whitted().environment.skybox->faces[1] == "sky/left.png");
}

TEST_CASE("env without its files is a warning, and the scene keeps its background") {
    const Scratch scratch("etalon_env_missing");
    make_faces(scratch.path / "sky", {"right.jpg", "left.png", "top.jpg", "front.jpg", "back.hdr"});
    const LoadResult r = load_beside(scratch.path, "bclr 1 0 0\nenv sky");
    REQUIRE(r.diagnostics.size() == 1);
    CHECK(r.diagnostics[0].line == 2);
    CHECK(r.diagnostics[0].column == 5);
    CHECK(r.diagnostics[0].message ==
          "no skybox in 'sky': nothing found for bottom, as .jpg, .png, .exr or .hdr");
    CHECK_FALSE(r.scene->whitted().environment.skybox);
    CHECK(r.scene->whitted().environment.background == Color(1, 0, 0));
}

TEST_CASE("a directory is not a face of a skybox") {
    const Scratch scratch("etalon_env_directory");
    make_faces(scratch.path / "sky", {"right.jpg", "left.png", "top.jpg", "front.jpg", "back.hdr"});
    fs::create_directories(scratch.path / "sky/bottom.jpg");
    CHECK_FALSE(load_beside(scratch.path, "env sky").scene->whitted().environment.skybox);
}

TEST_CASE("legacy looks a skybox up as the old programs did") {
    const Scratch scratch("etalon_env_legacy");
    make_faces(scratch.path / "sky", faces(".jpg"));
    LoadOptions legacy;
    legacy.legacy = true;
    CHECK(
        load_beside(scratch.path, "env sky", legacy).scene->whitted().environment.skybox->nearest);
}
