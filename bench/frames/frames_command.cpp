// etalon-bench frames: the time of each stage of a frame, and the share of intersection.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/common/backends.h"
#include "app/common/exit_status.h"
#include "app/common/fail.h"
#include "app/common/output.h"
#include "app/common/provenance.h"
#include "app/common/signals.h"
#include "bench/bench_subcommands.h"
#include "bench/frames/frame_report.h"
#include "bench/frames/measure_frame.h"
#include "bench/frames/scene_names.h"
#include "bench/frames/scratch_folder.h"
#include "bench/scenes/bench_scene.h"
#include "core/scene/resize.h"

namespace etalon {
namespace {

using Json = nlohmann::ordered_json;

struct FramesArguments {
    std::vector<std::string> scenes;
    std::string json;
    bool wide = false;
    frames::FrameConfig config;

    table::Detail detail() const { return wide ? table::Detail::wide : table::Detail::narrow; }
};

/// Writes the file, if there is to be one; `stopped` is why the figures are incomplete, or null.
bool write_file(const FramesArguments& a, const std::vector<frames::FrameFigures>& figures,
                const Json& stopped) {
    if (a.json.empty()) return true;
    Json json = provenance();
    json["repeats"] = a.config.repeats;
    json["frames"] = Json::array();
    for (const frames::FrameFigures& f : figures) json["frames"].push_back(json_of(f));
    json["stopped"] = stopped;
    return write_json(a.json, json);
}

/// Measures the scenes until a stop or the first error, which it returns. Writes the file after
/// each scene, in case the next one exhausts the memory.
std::string measure_all(const FramesArguments& a, std::vector<frames::FrameFigures>& figures) {
    for (const std::string& scene : a.scenes) {
        if (a.config.is_over()) break;
        const auto frame = frames::measure_frame(scene, a.config);
        if (!frame) return frame.error;
        for (frames::FrameFigures f : frame.value) {
            f.scene = frames::short_name(scene, a.scenes);
            figures.push_back(std::move(f));
        }
        const bool is_last = &scene == &a.scenes.back();
        if (!is_last && is_replaceable(a.json)) write_file(a, figures, "error");
    }
    return {};
}

/// Writes the tables and the file; `stopped` as for write_file().
bool write_results(const FramesArguments& a, const std::vector<frames::FrameFigures>& figures,
                   const Json& stopped) {
    write_table(a.json, table_of(figures, a.detail()));
    if (!stopped.is_null()) {
        write_table(a.json,
                    fmt::format("Stopped by {} {}: not all frames and repeats.\n",
                                stopped == "error" ? "an" : "a", stopped.get<std::string>()));
    }
    return write_file(a, figures, stopped);
}

int measure_frames(FramesArguments a) {
    for (const std::string& scene : a.scenes) {
        const std::string error = bench::check_scene_name(scene);
        if (!error.empty()) return fail(exit_unusable, error);
    }
    const auto [clash, status] = check_outputs({a.json}, a.scenes);
    if (!clash.empty()) return fail(status, clash);
    const frames::ScratchFolder folder;
    if (!folder.error().empty()) return fail(exit_not_written, folder.error());
    a.config.image = folder.file("frame.exr");
    const SignalGuard signals;
    a.config.stop = &signals.raised();
    std::string lost;
    a.config.check_files = [&](const std::vector<std::string>& files) {
        return lost = find_clash({a.json}, files);
    };
    std::vector<frames::FrameFigures> figures;
    const std::string error = measure_all(a, figures);
    if (!lost.empty()) return fail(exit_usage, lost);
    if (!error.empty()) fail(exit_unusable, error);
    const bool by_signal = signals.signal() != 0;
    const Json stopped = by_signal ? Json("signal") : error.empty() ? Json() : Json("error");
    if (!write_results(a, figures, stopped)) return exit_not_written;
    if (by_signal) return exit_signal + signals.signal();
    return error.empty() ? exit_done : exit_unusable;
}

}  // namespace

Action declare_frames(Options& options) {
    auto a = std::make_shared<FramesArguments>();
    options.add("SCENE", a->scenes, "Scene files, or names of `etalon-bench speed --list`")
        .required()
        .each_once();
    options
        .add("-b,--backends", a->config.backends,
             "Comma-separated list of backends, measured in turn (default: the scene's)")
        .by_commas()
        .one_of(backend_names());
    options
        .add("--width", a->config.width,
             "Width of the image in pixels; its height follows (default: the scene's)")
        .within(1, max_image_side);
    options.add("--spp", a->config.samples, "Number of samples per pixel (default: the scene's)")
        .within(1, 1 << 16);
    options.add("--repeat", a->config.repeats, "Number of times each stage is measured")
        .within(1, 1000)
        .show_default();
    options.add_flag("--wide", a->wide, "Show all columns, not only those that fit 100 characters");
    options.add("--json", a->json, "Write the results to this JSON file; - is standard output")
        .value("FILE");
    return [a] { return measure_frames(*a); };
}

}  // namespace etalon
