// Real scenes, where this machine has them.
#include <filesystem>

#include "core/formats/write/write.h"
#include "core/numerics/random.h"
#include "tests/catch.h"
#include "tests/formats/corners.h"
#include "tests/formats/p3f_text.h"
#include "tests/formats/same_scene.h"
#include "tests/formats/sane_scene.h"
#include "tests/formats/shared_scenes.h"
#include "tests/temporary_folder.h"

using namespace etalon;

namespace {

namespace fs = std::filesystem;

/// Returns the paths of small files of every format that can be read.
std::vector<std::string> small_files() {
    std::vector<std::string> list;
    for (const std::string_view name : format_names()) {
        for (const std::string& path : shared_scenes(std::string(name), "." + std::string(name))) {
            if (fs::file_size(path) <= 20000) list.push_back(path);
        }
    }
    return list;
}

}  // namespace

TEST_CASE("every real P3F scene is read without a warning, but for the one with stray numbers",
          "[needs_shared_scenes]") {
    const std::vector<std::string> paths = shared_scenes("p3f", ".p3f");
    SKIP_UNLESS(!paths.empty(), "no scenes in " << shared_scenes_folder() / "p3f");
    for (const std::string& path : paths) {
        const LoadResult r = load_scene(path);
        CAPTURE(path);
        REQUIRE(r.scene);
        CHECK(insanity(r) == "");
        CHECK(r.scene->geometry.primitives.size() >= 3);
        const bool stray = path.find("dragon_stray_numbers") != path.npos;
        CHECK(r.diagnostics.size() == (stray ? 1 : 0));
        if (!stray) continue;
        CHECK(r.diagnostics[0].line == 16);
        CHECK(r.diagnostics[0].column == 29);
        CHECK(r.scene->geometry.all<Triangle>().size() == 100000);
        CHECK(vertex_count(*r.scene) == 50000);
        CHECK(r.scene->whitted().lights.size() == 2);
    }
}

TEST_CASE("every real P3F scene is the same when it is written and read again",
          "[needs_shared_scenes]") {
    const std::vector<std::string> paths = shared_scenes("p3f", ".p3f");
    SKIP_UNLESS(!paths.empty(), "no scenes in " << shared_scenes_folder() / "p3f");
    for (const std::string& path : paths) {
        CAPTURE(path);
        const LoadResult r = load_scene(path);
        const WrittenScene written = write_p3f(*r.scene, r.settings, fs::path(path).parent_path());
        CHECK(written.lost.empty());
        const LoadResult again = load_scene_text(written.text, path);
        CHECK(again.diagnostics.empty());
        REQUIRE(again.scene);
        CHECK(difference(r, again) == "");
    }
}

TEST_CASE("every real SCE scene is read without a warning", "[needs_shared_scenes]") {
    const std::vector<std::string> paths = shared_scenes("sce", ".sce");
    SKIP_UNLESS(!paths.empty(), "no scenes in " << shared_scenes_folder() / "sce");
    for (const std::string& path : paths) {
        const LoadResult r = load_scene(path);
        CAPTURE(path, messages(r));
        REQUIRE(r.scene);
        CHECK(r.diagnostics.empty());
        CHECK(r.scene->format == "sce");
        CHECK(insanity(r) == "");
        CHECK(r.scene->geometry.primitives.size() >= 5);
        CHECK_FALSE(r.scene->whitted().lights.empty());
    }
}

TEST_CASE("every real NFF scene is read without a warning", "[needs_shared_scenes]") {
    const auto count = [](const LoadResult& r) { return r.scene->geometry.primitives.size(); };
    const std::pair<const char*, std::size_t> primitives[] = {
        {"balls", 7382}, {"gears", 9345}, {"mount", 8196}, {"teapot_s12", 9264}, {"tetra", 4096}};
    for (const auto& [name, expected] : primitives) {
        const std::string path = shared_scene("nff", name);
        SKIP_UNLESS(fs::exists(path), path << " does not exist");
    }
    for (const std::string& path : shared_scenes("nff", ".nff")) {
        const LoadResult r = load_scene(path);
        CAPTURE(path);
        REQUIRE(r.scene);
        CHECK(r.diagnostics.empty());
        CHECK(r.scene->format == "nff");
        CHECK(insanity(r) == "");
        for (const auto& [name, expected] : primitives) {
            if (fs::path(path).stem() == name) CHECK(count(r) == expected);
        }
    }
}

TEST_CASE("every real PRT scene is read without a warning", "[needs_shared_scenes]") {
    const std::pair<const char*, std::size_t> items[] = {
        {"balls", 7382}, {"example1", 13}, {"example2", 196}, {"tetra", 4096}};
    for (const auto& [name, expected] : items) {
        const std::string path = shared_scene("prt", name);
        SKIP_UNLESS(fs::exists(path), path << " does not exist");
    }
    for (const std::string& path : shared_scenes("prt", ".prt")) {
        const LoadResult r = load_scene(path);
        CAPTURE(path);
        REQUIRE(r.scene);
        CHECK(r.diagnostics.empty());
        CHECK(r.scene->format == "prt");
        CHECK(insanity(r) == "");
        for (const auto& [name, expected] : items) {
            if (fs::path(path).stem() == name) CHECK(r.scene->geometry.item_count() == expected);
        }
    }
}

TEST_CASE("damaged real scenes give a scene or an error", "[needs_shared_scenes]") {
    Random random(7);
    const std::vector<std::string> paths = small_files();
    SKIP_UNLESS(!paths.empty(), "no scenes in " << shared_scenes_folder());
    for (const std::string& path : paths) {
        const std::string text = test::content_of(path);
        CAPTURE(path);
        for (int i = 0; i < 100; ++i) {
            std::string damaged =
                text.substr(0, i % 10 == 0 ? random.index(text.size()) : text.size());
            if (!damaged.empty())
                damaged[random.index(damaged.size())] ^= static_cast<char>(1U << random.index(8));
            const LoadResult r = load_scene_text(damaged, path);
            CHECK((r.scene ? insanity(r).empty() : !r.diagnostics.empty()));
        }
    }
}
