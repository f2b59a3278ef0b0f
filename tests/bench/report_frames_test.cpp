// The frames of a report: of the project's scenes, of families, and of given files.
#include <filesystem>

#include "bench/report/command_lines.h"
#include "bench/report/sections/sections.h"
#include "bench/report/tasks.h"
#include "tests/app/run_program.h"
#include "tests/catch.h"

using namespace etalon::bench_report;
using namespace etalon::test;

namespace {

/// Runs the tasks of all frames of an origin.
Results measured(Settings settings, FrameOrigin origin) {
    std::erase_if(settings.frames, [&](const FrameRequest& f) { return f.origin != origin; });
    for (FrameRequest& f : settings.frames) f.width = 16;
    Results results;
    results.settings = settings;
    const std::atomic<bool> stop = false;
    for (const Task& task : frame_tasks(settings)) {
        task.run(results, {stop, etalon::Deadline(), [](double) {}});
    }
    return results;
}

/// A clock that goes on by a second whenever it is read.
double seconds_of_calls() {
    static std::atomic<int> calls = 0;
    return ++calls;
}

/// A clock that stands still after its first second of ten, which it has shown once.
double late_seconds() {
    static std::atomic<int> calls = 0;
    return calls++ == 0 ? 0 : 9;
}

const std::string report = "exec '" ETALON_BINARY_DIR "/bin/etalon-bench' report --quick ";

}  // namespace

TEST_CASE("A report measures the frames of the scene files in a folder that is given, by name") {
    const Folder f;
    std::filesystem::create_directory(f.path("scenes"));
    f.write("scenes/b.p3f", small_scene);
    f.write("scenes/a.p3f", small_scene);
    f.write("scenes/readme.txt", "none");
    Settings settings = quick_settings();
    REQUIRE(add_frames({f.path("scenes")}, settings).empty());
    CHECK(frame_tasks(settings).front().what == "frames of " + f.path("scenes/a.p3f"));
    const Results results = measured(settings, FrameOrigin::given);
    REQUIRE(results.frames.list.size() == 2);
    CHECK(results.frames.list[0].figures.scene == "a");
    CHECK(results.frames.list[1].figures.width == 16);
    const Section section = frames_section(results);
    REQUIRE(section.figures.size() == 1);
    CHECK_THAT(section.figures[0].command,
               ContainsSubstring("scenes/a.p3f ") && ContainsSubstring("--width 16 "));
    CHECK_THAT(command_of(settings), ContainsSubstring("scenes/b.p3f"));
}

TEST_CASE("A report measures the frames of the families that etalon-scenes makes") {
    Settings settings = quick_settings();
    for (FrameRequest& f : settings.frames) f.size = 2;
    const Results results = measured(settings, FrameOrigin::family);
    REQUIRE(results.frames.list.size() == settings.spd_scenes.size());
    for (const MeasuredFrame& frame : results.frames.list) {
        CHECK(frame.figures.render > 0);
        CHECK(frame.figures.load > 0);
    }
}

TEST_CASE("A report's frame ends when the time is up, without figures") {
    const Folder f;
    f.write("a.p3f", small_scene);
    Results results;
    results.settings = quick_settings();
    results.settings.frames.clear();
    REQUIRE(add_frames({f.path("a.p3f")}, results.settings).empty());
    results.settings.frames.front().samples = 1 << 16;
    const std::atomic<bool> stop = false;
    const etalon::Deadline deadline(20, seconds_of_calls);
    frame_tasks(results.settings).front().run(results, {stop, deadline, [](double) {}});
    CHECK(deadline.is_over());
    CHECK(results.frames.list.empty());
}

TEST_CASE("A report's frames: given little time left, then they have all of their samples") {
    Results results;
    results.settings = quick_settings();
    const FrameRequest request = results.settings.frames.front();
    REQUIRE(request.samples == 4);
    results.settings.frames = {request};
    results.settings.frames.front().width = 16;
    const std::atomic<bool> stop = false;
    const etalon::Deadline deadline(10, late_seconds);
    frame_tasks(results.settings).front().run(results, {stop, deadline, [](double) {}});
    REQUIRE(results.frames.list.size() == 1);
    CHECK(results.frames.list.front().figures.samples == 4);
}

TEST_CASE("The quick report takes a given scene's frames with as many samples as its own scenes'") {
    const Folder f;
    f.write("a.p3f", small_scene);
    Settings quick = quick_settings(), full = full_settings();
    REQUIRE(add_frames({f.path("a.p3f")}, quick).empty());
    CHECK(quick.frames.back().samples == quick.frames.front().samples);
    REQUIRE(add_frames({f.path("a.p3f")}, full).empty());
    CHECK(full.frames.back().samples == 0);  // the scene's own
}

TEST_CASE("The command lines of a report are those of a shell, with its folder") {
    const Folder f;
    f.write("a<b>&.p3f", small_scene);
    Settings settings = quick_settings();
    settings.folder = "my report";
    settings.foreign_table = "other's.tsv";
    REQUIRE(add_frames({f.path("a<b>&.p3f")}, settings).empty());
    const std::string scene = " '" + f.path("a<b>&.p3f") + "' ";
    CHECK_THAT(command_of(settings), ContainsSubstring(scene) &&
                                         ContainsSubstring("--foreign 'other'\\''s.tsv' ") &&
                                         ContainsSubstring(" -o 'my report'"));
    CHECK_THAT(frames_command(settings, FrameOrigin::given), ContainsSubstring(scene));
}

TEST_CASE("A report's command for the classic scenes renders each with each of its backends") {
    const std::string command = spd_command(quick_settings());
    CHECK_THAT(command, ContainsSubstring("for backend in grid bvh embree embree-user "
                                          "embree-builtin; do ") &&
                            ContainsSubstring(" --spd -b $backend "));
}

TEST_CASE("A report has more time if it is given scenes") {
    const Folder f;
    f.write("a.p3f", small_scene);
    Settings quick = quick_settings(), full = full_settings();
    const double before = quick.seconds_limit;
    REQUIRE(add_frames({f.path("a.p3f")}, quick).empty());
    CHECK(quick.seconds_limit > before);
    REQUIRE(add_frames({f.path("a.p3f")}, full).empty());
    CHECK(full.seconds_limit == 0);
}

TEST_CASE("A report says at once which scene it cannot find") {
    const Folder f;
    std::filesystem::create_directory(f.path("empty"));
    for (const char* scene : {"nowhere.p3f", "empty"}) {
        const auto r = f.shell(report + scene);
        CHECK(r.status == 3);
        CHECK_THAT(r.err, ContainsSubstring(scene));
        CHECK_FALSE(f.has("report/index.html"));
    }
}

TEST_CASE("A frame's process has a start that took time before main") {
    const Folder f;
    const auto r = f.shell("exec '" ETALON_BINARY_DIR
                           "/bin/etalon-bench' frames spheres:20 --width 20 --repeat 1");
    CHECK(r.status == 0);
    CHECK_THAT(r.out, ContainsSubstring("CPU seconds       start   load"));
    CHECK_THAT(r.out, !ContainsSubstring("bvh             0.000  "));
}
