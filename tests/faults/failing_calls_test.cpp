// Makes one allocation or thread creation fail, each call in turn: the program must end with the
// correct image or with a message, and leave no other files.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "tests/app/run_program.h"
#include "tests/catch.h"
#include "tests/sanitized.h"

using namespace etalon::test;

namespace {

struct Task {
    std::string begin;    ///< suffix of the file after whose opening calls are counted
    std::string command;  ///< arguments of etalon, to make image.exr
};

/// Renders a scene below scenes/, small.
Task rendering(const std::string& scene, const std::string& options) {
    return {scene.substr(scene.find('/')),
            fmt::format("render '" ETALON_SOURCE_DIR
                        "/scenes/{}' --resolution 16x12 --spp 2 -q -o image.exr {}",
                        scene, options)};
}

/// The same with a page.
Task serving(const std::string& scene, const std::string& options) {
    Task task = rendering(scene, options);
    task.command.replace(0, std::string("render").size(), "serve");
    return task;
}

const std::vector<Task> renderings = {
    rendering("features/glass.p3f", "-b bvh -t 1"),
    rendering("features/meshes.p3f", "-b embree -t 1"),
    rendering("features/meshes.p3f", "-b grid -t 2"),
    rendering("pbrt/materials.pbrt", "-b bvh -t 2"),
    rendering("pbrt/textures.pbrt", "-b embree-user -t 2"),
};

/// Runs a task whose `at`-th call of a kind fails.
ProgramResult run(const Folder& f, const Task& task, const std::string& kind, long at) {
    return f.shell(
        fmt::format("rm -f image.exr; timeout -s KILL 60 env FAILS={} FAILS_AT={} FAILS_AFTER='{}' "
                    "FAILS_COUNT=count "
                    "LD_PRELOAD='" ETALON_BINARY_DIR "/lib/failing_calls.so' '" ETALON_BINARY_DIR
                    "/bin/etalon' {}",
                    kind, at, task.begin, task.command));
}

/// Result of a run without a fault.
struct Whole {
    Whole(const Folder& f, const Task& task, const std::string& kind) {
        const ProgramResult r = run(f, task, kind, 0);
        CAPTURE(task.command, r.err);
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
    CAPTURE(task.command, kind, at, r.status, r.err);
    if (r.status == 0) {
        CHECK(f.read("image.exr") == whole.image);
    } else {
        CHECK((r.status == 3 || r.status == 4));
        CHECK_THAT(r.err, ContainsSubstring("error: "));
        CHECK(!f.has("image.exr"));
    }
    CHECK(f.shell("ls -A | grep -vx -e image.exr -e count").out == "");
}

/// Number of calls of a task that fail in the default tests.
constexpr long runs = 25;

/// Makes every `step`-th call fail, and the last ones, which are made after the image was written.
void check_each(const Folder& f, const Task& task, long step) {
    const Whole whole(f, task, "memory");
    REQUIRE(whole.calls > 100);
    constexpr long last = 4;
    for (long at = 1; at <= whole.calls; at += at < whole.calls - last ? step : 1) {
        check(f, task, "memory", std::min(at, whole.calls), whole);
    }
}

}  // namespace

TEST_CASE("A failing allocation is reported, or changes nothing", "[faults][needs_preload]") {
    SKIP_UNLESS(!is_sanitized, no_preload);
    const Folder f;
    for (const Task& task : renderings) {
        check_each(f, task, Whole(f, task, "memory").calls / runs);
    }
}

TEST_CASE("A failing allocation at the start of the program is reported",
          "[faults][needs_preload]") {
    SKIP_UNLESS(!is_sanitized, no_preload);
    const Folder f;
    const Task task{"", "--version"};
    const std::string version = run(f, task, "memory", 0).out;
    REQUIRE(version.starts_with("etalon "));
    int failures = 0;
    for (long at = 1; at <= 60; ++at) {
        const ProgramResult r = run(f, task, "memory", at);
        CAPTURE(at, r.out, r.err);
        CHECK((r.status == 0 || r.status == 3));
        if (r.status == 0) CHECK(r.out == version);
        if (r.status != 0) CHECK_THAT(r.err, ContainsSubstring("error: "));
        failures += r.status != 0;
    }
    CHECK(failures > 0);
}

TEST_CASE("A failing allocation where a library must not throw is reported",
          "[faults][needs_preload]") {
    SKIP_UNLESS(!is_sanitized, no_preload);
    const Folder parts, f;
    for (const int part : {1, 2}) {
        const Task rendered = rendering("features/glass.p3f", fmt::format("--part {}/2", part));
        REQUIRE(run(parts, rendered, "memory", 0).status == 0);
        REQUIRE(parts.shell(fmt::format("mv image.exr {}.exr", part)).status == 0);
    }
    const Task merging{
        "", fmt::format("merge '{}' '{}' -o image.exr", parts.path("1.exr"), parts.path("2.exr"))};
    check_each(f, merging, Whole(f, merging, "memory").calls / (4 * runs));
}

TEST_CASE("Every failing allocation is reported, or changes nothing",
          "[faults][needs_preload][long]") {
    SKIP_UNLESS(!is_sanitized, no_preload);
    const Folder f;
    for (const Task& task : renderings) check_each(f, task, 1);
}

TEST_CASE("A thread that cannot be started is reported, or changes nothing",
          "[faults][needs_preload]") {
    SKIP_UNLESS(!is_sanitized, no_preload);
    const Folder f;
    std::vector<Task> tasks = renderings;
    tasks.push_back(serving("features/glass.p3f", "-t 4"));
    for (Task task : tasks) {
        task.command.back() = '4';
        const Whole whole(f, task, "thread");
        for (long at = 1; at <= 4; ++at) check(f, task, "thread", at, whole);
    }
}

TEST_CASE("A thread that cannot be started ends a measurement of speed",
          "[faults][needs_preload][needs_two_cores]") {
    SKIP_UNLESS(!is_sanitized, no_preload);
    SKIP_UNLESS(std::thread::hardware_concurrency() >= 2, "a single core");
    const Folder f;
    const auto speed = [&](int at) {
        return f.shell(fmt::format(
            "timeout -s KILL 60 env FAILS=thread FAILS_AT={} FAILS_AFTER= FAILS_COUNT=count "
            "LD_PRELOAD='" ETALON_BINARY_DIR "/lib/failing_calls.so' '" ETALON_BINARY_DIR
            "/bin/etalon-bench' speed --scene spheres:20 --threads 2 --max-rays 100 --repeat 1 "
            "--backends bvh --oracle 0 --rays camera",
            at));
    };
    REQUIRE(speed(0).status == 0);
    const int threads = std::stoi(f.read("count"));
    REQUIRE(threads >= 2);
    for (int at = 1; at <= threads; ++at) {
        const ProgramResult r = speed(at);
        CAPTURE(at, r.status, r.err);
        CHECK((r.status == 0 || r.status == 3));
        if (r.status == 3) CHECK_THAT(r.err, ContainsSubstring("error: "));
    }
}

TEST_CASE("A view whose thread cannot be started is left out", "[faults][needs_preload]") {
    SKIP_UNLESS(!is_sanitized, no_preload);
    const Folder f;
    const Task task = rendering("features/glass.p3f", "-b bvh -t 1 --tev 127.0.0.1:1");
    const Whole whole(f, task, "thread");
    const ProgramResult r = run(f, task, "thread", 1);
    CHECK(r.status == 0);
    CHECK_THAT(r.err, ContainsSubstring("warning: tev: Resource temporarily unavailable"));
    CHECK(f.read("image.exr") == whole.image);
}
