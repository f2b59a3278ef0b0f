#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "app/common/console.h"
#include "app/common/output.h"
#include "bench/frames/measure_frame.h"
#include "bench/report/measure/rendered.h"
#include "scenes/generate/scene_text.h"

namespace etalon::bench_report {
namespace {

/// A scene file, which is removed at the end if it was written for the measurement.
class SceneFile {
  public:
    explicit SceneFile(const FrameRequest& request) : path_(request.scene) {
        if (request.origin == FrameOrigin::shipped) path_ = shipped_path(request.scene);
        if (request.origin != FrameOrigin::family) return;
        made_ = std::filesystem::temp_directory_path() /
                fmt::format("etalon_{}_{}.p3f", request.scene, getpid());
        path_ = made_.string();
        write_text(path_, generate::scene_text(request.scene, request.size));
    }
    ~SceneFile() {
        std::error_code ignored;
        if (!made_.empty()) std::filesystem::remove(made_, ignored);
    }
    SceneFile(const SceneFile&) = delete;
    SceneFile& operator=(const SceneFile&) = delete;

    const std::string& path() const { return path_; }

  private:
    std::filesystem::path made_;
    std::string path_;
};

void measure(const FrameRequest& request, Results& results) {
    const SceneFile file(request);
    Result<frames::FrameFigures> frame = frames::measure_frame(
        file.path(), {results.settings.frame_repeats, request.width, request.samples, {}});
    if (!frame) return print_message("etalon-bench: warning: {}\n", frame.error);
    frame.value.scene = request.origin == FrameOrigin::given
                            ? std::filesystem::path(request.scene).stem().string()
                            : request.scene;
    results.frames.add({request.origin, std::move(frame.value)});
}

/// Estimates two renderings, and for each repeat about one and a half more. The time of a scene's
/// own resolution is unknown before it is loaded.
double seconds_for(const FrameRequest& request, const Settings& settings) {
    const double renderings = 2 + 1.5 * settings.frame_repeats;
    if (request.samples == 0) return renderings * (request.width > 0 ? 0.1 : 1);
    const double samples = 0.7 * request.width * request.width * request.samples;
    return 1e-6 * renderings * samples * microseconds_of_sample(request.scene);
}

}  // namespace

std::vector<Task> frame_tasks(const Settings& settings) {
    std::vector<Task> tasks;
    for (const FrameRequest& request : settings.frames) {
        tasks.push_back({"frames of " + request.scene, seconds_for(request, settings),
                         [request](Results& results, const TaskProgress& task_progress) {
                             if (!task_progress.is_over()) measure(request, results);
                         }});
    }
    return tasks;
}

}  // namespace etalon::bench_report
