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
