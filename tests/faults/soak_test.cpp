// Renders many changing scenes in one process, with every backend: memory must not grow after the
// first rounds.
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/formats/load.h"
#include "core/shading/textured_cut_outs.h"
#include "tests/catch.h"
#include "tests/render/test_images.h"
#include "tests/sanitized.h"

using namespace etalon;
using namespace etalon::test;

namespace {

namespace fs = std::filesystem;

std::vector<std::string> scene_files() {
    std::vector<std::string> files;
    for (const char* folder : {"features", "pbrt"}) {
        for (const auto& entry :
             fs::directory_iterator(fs::path(ETALON_SOURCE_DIR) / "scenes" / folder)) {
            const fs::path extension = entry.path().extension();
            if (extension == ".p3f" || extension == ".pbrt") files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

/// Loads a scene, whole or truncated, and renders the result, if any. Returns whether there was a
/// scene.
bool render_once(const std::string& file, const Backend& backend, bool whole) {
    std::ifstream stream(file, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(stream)), {});
    if (!whole) text.resize(text.size() / 2);
    LoadResult loaded = load_scene_text(text, file);
    if (!loaded.scene) return false;
    find_integrator(loaded.settings.integrator)->prepare_scene(*loaded.scene, loaded.settings);
    std::vector<std::string> problems;
    make_cut_outs(*loaded.scene, problems);
    loaded.settings.resolution = {12, 9};
    loaded.settings.samples_per_pixel = 1;
    const Rendering rendering = render_with(*loaded.scene, backend, loaded.settings);
    return rendering.counts.camera >= 12 * 9;
}

/// Returns the memory in use by the process, in bytes, without memory cached by the allocator.
std::size_t resident_bytes() {
    malloc_trim(0);
    std::ifstream status("/proc/self/statm");
    std::size_t all = 0, resident = 0;
    status >> all >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// Renders every scene with every backend in each round.
void check_flat(int warm_up, int rounds, std::size_t scenes_of_a_round) {
    const std::vector<std::string> files = scene_files();
    REQUIRE(files.size() > 20);
    std::size_t before = 0, next = 0, rendered = 0;
    for (int round = 0; round < warm_up + rounds; ++round) {
        if (round == warm_up) before = resident_bytes();
        for (std::size_t i = 0; i < scenes_of_a_round; ++i, ++next) {
            const Backend& backend = all_backends()[next % all_backends().size()];
            rendered += render_once(files[next % files.size()], backend, next % 5 != 0);
        }
    }
    const std::size_t after = resident_bytes();
    CAPTURE(before, after, rendered, next);
    CHECK(rendered > next / 2);
    // A sanitizer keeps what was freed, to find its use.
    if (!is_sanitized) CHECK(after < before + (8 << 20));
}

}  // namespace

TEST_CASE("Renderings one after the other leave no memory behind", "[faults]") {
    check_flat(3, 6, 30);
}

TEST_CASE("Thousands of renderings leave no memory behind", "[faults][long]") {
    check_flat(5, 200, 60);
}
