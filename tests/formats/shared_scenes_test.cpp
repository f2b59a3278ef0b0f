// Real scenes, where this machine has them.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "core/formats/write/write.h"
#include "tests/catch.h"
#include "tests/formats/p3f_text.h"
#include "tests/formats/same_scene.h"
#include "tests/formats/sane_scene.h"

using namespace etalon;

namespace {

namespace fs = std::filesystem;

fs::path scenes() {
    const char* const named = std::getenv("ETALON_SHARED_SCENES");
    return named ? fs::path(named) : fs::path(ETALON_SOURCE_DIR) / "../shared/scenes";
}

/// All files of an extension in a folder of the scenes; none where the folder is not there.
std::vector<std::string> files(const std::string& folder, const std::string& extension) {
    std::vector<std::string> list;
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(scenes() / folder, missing)) {
        if (entry.path().extension() == extension) list.push_back(entry.path().string());
    }
    return list;
}

std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("every real P3F scene is read without a warning, but for the one with stray numbers") {
    for (const std::string& path : files("p3f", ".p3f")) {
        const LoadResult r = load_scene(path);
        CAPTURE(path);
        REQUIRE(r.scene);
        CHECK(insanity(*r.scene) == "");
        CHECK(r.scene->primitives.size() >= 3);
        const bool stray = path.find("dragon_stray_numbers") != path.npos;
        CHECK(r.diagnostics.size() == (stray ? 1 : 0));
        if (!stray) continue;
        CHECK(r.diagnostics[0].line == 16);
        CHECK(r.diagnostics[0].column == 29);
        CHECK(r.scene->all<Triangle>().size() == 100000);
        CHECK(r.scene->vertices.size() == 50000);
        CHECK(r.scene->lights.size() == 2);
    }
}

TEST_CASE("every real P3F scene is the same when it is written and read again") {
    for (const std::string& path : files("p3f", ".p3f")) {
        CAPTURE(path);
        const LoadResult r = load_scene(path);
        const WrittenScene written = write_p3f(*r.scene, fs::path(path).parent_path());
        CHECK(written.lost.empty());
        const LoadResult again = load_scene_text(written.text, path);
        CHECK(again.diagnostics.empty());
        REQUIRE(again.scene);
        CHECK(difference(*r.scene, *again.scene) == "");
    }
}

TEST_CASE("real scenes of other formats are recognised") {
    const std::pair<const char*, const char*> kinds[] = {{"nff", "an NFF scene"},
                                                         {"prt", "a PRT scene"}};
    for (const auto& [name, described] : kinds) {
        for (const std::string& path : files(name, std::string(".") + name)) {
            const LoadResult r = load_scene_text(content(path), "f");
            CAPTURE(path);
            REQUIRE(r.diagnostics.size() == 1);
            CHECK(r.diagnostics[0].message.find(described) != std::string::npos);
        }
    }
}

TEST_CASE("damaged real scenes give a scene or an error") {
    std::mt19937 random(7);
    for (const std::string& path : files("p3f", ".p3f")) {
        const std::string text = content(path);
        if (text.size() > 20000) continue;
        CAPTURE(path);
        for (int i = 0; i < 100; ++i) {
            std::string damaged =
                text.substr(0, i % 10 == 0 ? random() % text.size() : text.size());
            if (!damaged.empty())
                damaged[random() % damaged.size()] ^= static_cast<char>(1U << (random() % 8));
            const LoadResult r = load_p3f_text(damaged);
            CHECK((r.scene ? insanity(*r.scene).empty() : !r.diagnostics.empty()));
        }
    }
}
