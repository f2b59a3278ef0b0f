// One call for memory, or for a thread, fails, whichever it is: the program ends with the image
// that it would have made or with a message, and leaves nothing else behind.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::test;

namespace {

#ifdef ETALON_SANITIZED
constexpr bool can_preload = false;
#else
constexpr bool can_preload = true;
#endif

constexpr const char* no_preload =
    "a build without sanitizers, which libraries can be preloaded into";

struct Task {
    std::string scene;    ///< below scenes/
    std::string options;  ///< beside those that make it small
};

const std::vector<Task> tasks = {
    {"features/glass.p3f", "-b bvh -t 1"},         {"features/meshes.p3f", "-b embree -t 1"},
    {"features/meshes.p3f", "-b grid -t 2"},       {"pbrt/materials.pbrt", "-b bvh -t 2"},
    {"pbrt/textures.pbrt", "-b embree-user -t 2"},
};

/// Runs a task whose `at`-th call of a kind fails, once it has opened the scene.
ProgramResult run(const Folder& f, const Task& task, const std::string& kind, long at) {
    const std::string name = task.scene.substr(task.scene.find('/'));
    return f.shell(
        fmt::format("rm -f image.exr; timeout -s KILL 60 env FAILS={} FAILS_AT={} FAILS_AFTER='{}' "
                    "FAILS_COUNT=count "
                    "LD_PRELOAD='" ETALON_BINARY_DIR "/lib/failing_calls.so' '" ETALON_BINARY_DIR
                    "/bin/etalon' render '" ETALON_SOURCE_DIR "/scenes/{}' "
                    "{} --resolution 16x12 --spp 1 -q -o image.exr",
                    kind, at, name, task.scene, task.options));
}

/// What a run without a fault does.
struct Whole {
    Whole(const Folder& f, const Task& task, const std::string& kind) {
        const ProgramResult r = run(f, task, kind, 0);
        CAPTURE(task.scene, r.err);
        REQUIRE(r.status == 0);
        image = f.read("image.exr");
        calls = std::atol(f.read("count").c_str());
    }

    std::string image;
    long calls;
};

void check(const Folder& f, const Task& task, const std::string& kind, long at,
           const Whole& whole) {
    const ProgramResult r = run(f, task, kind, at);
    CAPTURE(task.scene, task.options, kind, at, r.status, r.err);
    if (r.status == 0) {
        CHECK(f.read("image.exr") == whole.image);
    } else {
        CHECK((r.status == 3 || r.status == 4));
        CHECK_THAT(r.err, ContainsSubstring("error: "));
        CHECK(!f.has("image.exr"));
    }
    CHECK(f.shell("ls -A | grep -vx -e image.exr -e count").out == "");
}

/// Lets every `step`-th call fail, and the last ones: those are made after the image was written.
void check_each(const Folder& f, const Task& task, long step) {
    const Whole whole(f, task, "memory");
    REQUIRE(whole.calls > 100);
    constexpr long last = 4;
    for (long at = 1; at <= whole.calls; at += at < whole.calls - last ? step : 1) {
        check(f, task, "memory", std::min(at, whole.calls), whole);
    }
}

}  // namespace

TEST_CASE("A call for memory that fails ends in words, or changes nothing",
          "[faults][needs_preload]") {
    SKIP_UNLESS(can_preload, no_preload);
    const Folder f;
    constexpr long runs = 25;
    for (const Task& task : tasks) {
        check_each(f, task, Whole(f, task, "memory").calls / runs);
    }
}

TEST_CASE("Every call for memory that fails ends in words, or changes nothing",
          "[faults][needs_preload][long]") {
    SKIP_UNLESS(can_preload, no_preload);
    const Folder f;
    for (const Task& task : tasks) check_each(f, task, 1);
}

TEST_CASE("A thread that cannot be started ends in words, or changes nothing",
          "[faults][needs_preload]") {
    SKIP_UNLESS(can_preload, no_preload);
    const Folder f;
    for (Task task : tasks) {
        task.options.back() = '4';
        const Whole whole(f, task, "thread");
        for (long at = 1; at <= 4; ++at) check(f, task, "thread", at, whole);
    }
}
