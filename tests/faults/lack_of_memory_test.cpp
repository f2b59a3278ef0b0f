// Loads, builds and renders scenes in this process while one call of operator new fails, each call
// in turn. Builds with the address sanitizer detect leaks and uses after free.
#include <memory>
#include <new>

#include "core/base/copyable_variant.h"
#include "core/formats/load.h"
#include "core/parallel/parallel.h"
#include "core/shading/textured_cut_outs.h"
#include "tests/catch.h"
#include "tests/fuzz/limited_memory.h"
#include "tests/render/test_images.h"

using namespace etalon;
using namespace etalon::test;
using etalon::fuzz::LimitedMemory;

namespace {

struct Task {
    std::string scene;  ///< path below scenes/
    std::string backend;
};

// Without Embree, which may use an allocator after its destruction if an allocation of its own
// failed; then the program ends.
const std::vector<Task> tasks = {
    {"features/glass.p3f", "bvh"},
    {"features/meshes.p3f", "grid"},
    {"pbrt/materials.pbrt", "none"},
};

using Pixels = std::vector<Color>;

/// Returns nothing if the lack of memory is reported as an error.
std::optional<Pixels> pixels_of(const Task& task) {
    LoadResult loaded = load_scene(std::string(ETALON_SOURCE_DIR "/scenes/") + task.scene);
    if (!loaded.scene) return std::nullopt;
    loaded.settings.resolution = {8, 6};
    loaded.settings.samples_per_pixel = 1;
    find_integrator(loaded.settings.integrator)->prepare_scene(*loaded.scene, loaded.settings);
    std::vector<std::string> problems;
    make_cut_outs(*loaded.scene, problems);
    return render_with(*loaded.scene, *find_backend(task.backend), loaded.settings).film.pixels();
}

struct TaskResult {
    std::optional<Pixels> pixels;
    bool has_failed_call;
};

/// Renders a task in which one call of operator new fails. Checks nothing itself, since a check
/// would also allocate memory.
TaskResult result_with_failing(std::uint32_t call, const Task& task) {
    const LimitedMemory memory(call);
    try {
        std::optional<Pixels> pixels = pixels_of(task);
        return {std::move(pixels), memory.has_failed()};
    } catch (const std::bad_alloc&) {
        return {std::nullopt, memory.has_failed()};
    }
}

}  // namespace

TEST_CASE("Every call of operator new that fails loses nothing", "[faults]") {
    const ThreadLimit one_thread(1);
    for (const Task& task : tasks) {
        const std::optional<Pixels> expected = pixels_of(task);
        REQUIRE(expected);
        std::uint32_t call = 1;
        TaskResult result = result_with_failing(call, task);
        while (result.has_failed_call) {
            CAPTURE(task.scene, call);
            CHECK((!result.pixels || *result.pixels == *expected));
            result = result_with_failing(++call, task);
        }
        CAPTURE(task.scene, call);
        CHECK(result.pixels == expected);
        CHECK(call > 100);
    }
}

TEST_CASE("A variant of lists that cannot be copied is not destroyed", "[faults]") {
    using Lists = CopyableVariant<std::vector<float>, std::vector<std::string>>;
    const std::vector<Lists> original = {std::vector<float>{1, 2},
                                         std::vector<std::string>{"longer than a short string"}};
    const auto is_copied = [&](std::uint32_t failing_call) {
        const LimitedMemory memory(failing_call);
        try {
            return std::vector<Lists>(original) == original;
        } catch (const std::bad_alloc&) {
            return false;
        }
    };
    std::uint32_t call = 1;
    while (!is_copied(call)) ++call;
    CHECK(call == 5);  // the vector, two lists, a string
}
