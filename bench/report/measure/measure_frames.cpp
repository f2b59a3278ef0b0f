#include <fmt/format.h>

#include <algorithm>

#include "app/common/console.h"
#include "app/common/output.h"
#include "bench/frames/measure_frame.h"
#include "bench/frames/scene_names.h"
#include "bench/frames/scratch_folder.h"
#include "bench/report/measure/rendered.h"
#include "scenes/generate/scene_text.h"

namespace etalon::bench_report {
namespace {

/// Returns the scene's file; that of a family is written to the folder.
std::string file_of(const FrameRequest& request, const frames::ScratchFolder& folder) {
    if (request.origin == FrameOrigin::shipped) return shipped_path(request.scene);
    if (request.origin == FrameOrigin::given) return request.scene;
    const std::string path = folder.file(request.scene + ".p3f");
    write_text(path, generate::scene_text(request.scene, request.size));
    return path;
}

std::string name_of(const FrameRequest& request, const Settings& settings) {
    if (request.origin != FrameOrigin::given) return request.scene;
    std::vector<std::string> given;
    for (const FrameRequest& f : settings.frames) {
        if (f.origin == FrameOrigin::given) given.push_back(f.scene);
    }
    return frames::short_name(request.scene, given);
}

Result<std::vector<frames::FrameFigures>> figures_of(const FrameRequest& request,
                                                     const Settings& settings,
                                                     const TaskProgress& task_progress) {
    const frames::ScratchFolder folder;
    if (!folder.error().empty()) return {{}, folder.error()};
    frames::FrameConfig config;
    config.repeats = settings.frame_repeats;
    config.width = request.width;
    config.samples = request.samples;
    config.image = folder.file("frame.exr");
    config.stop = &task_progress.stop;
    config.deadline = task_progress.deadline;
    return frames::measure_frame(file_of(request, folder), config);
}

void measure(const FrameRequest& request, Results& results, const TaskProgress& task_progress) {
    auto figures = figures_of(request, results.settings, task_progress);
    if (!figures) return print_message("etalon-bench: warning: {}\n", figures.error);
    for (frames::FrameFigures& frame : figures.value) {
        frame.scene = name_of(request, results.settings);
        results.frames.add({request.origin, std::move(frame)});
    }
}

}  // namespace

/// Begins with the scenes that were asked for, in case there is no time for all.
std::vector<Task> frame_tasks(const Settings& settings) {
    std::vector<FrameRequest> requests = settings.frames;
    // The algorithm of std::ranges returns a subrange, which clang 14 cannot compile.
    std::stable_partition(requests.begin(), requests.end(),
                          [](const FrameRequest& f) { return f.origin == FrameOrigin::given; });
    std::vector<Task> tasks;
    for (const FrameRequest& request : requests) {
        tasks.push_back({"frames of " + request.scene, seconds_for(request, settings),
                         [request](Results& results, const TaskProgress& task_progress) {
                             if (!task_progress.is_over()) measure(request, results, task_progress);
                         }});
    }
    return tasks;
}

}  // namespace etalon::bench_report
