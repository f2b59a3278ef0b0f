// etalon-bench frames: the time of each stage of a frame, and the share of intersection.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/common/backends.h"
#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "app/common/provenance.h"
#include "app/common/signals.h"
#include "bench/bench_subcommands.h"
#include "bench/frames/frame_report.h"
#include "bench/frames/measure_frame.h"
#include "core/scene/resize.h"

namespace etalon {
namespace {

using Json = nlohmann::ordered_json;

struct FramesArguments {
    std::vector<std::string> scenes;
    std::string json;
    bool wide = false;
    frames::Plan plan;

    table::Detail detail() const { return wide ? table::Detail::wide : table::Detail::narrow; }
};

int measure_frames(FramesArguments a) {
    if (const auto [error, status] = check_outputs({a.json}, a.scenes); !error.empty()) {
        print_message("etalon-bench: error: {}\n", error);
        return status;
    }
    const SignalGuard signals;
    a.plan.stop = &signals.raised();
    std::vector<frames::FrameFigures> figures;
    Json json = provenance();
    json["repeats"] = a.plan.repeats;
    json["frames"] = Json::array();
    for (const std::string& scene : a.scenes) {
        if (signals.signal() != 0) break;
        Result<frames::FrameFigures> frame = frames::measure_frame(scene, a.plan);
        if (!frame) {
            print_message("etalon-bench: error: {}\n", frame.error);
            return exit_unusable;
        }
        if (frame.value.repeats == 0) break;
        frame.value.scene = std::filesystem::path(scene).stem().string();
        json["frames"].push_back(json_of(frame.value));
        figures.push_back(std::move(frame.value));
    }
    write_table(a.json, table_of(figures, a.detail()));
    json["stopped"] = signals.signal() != 0 ? Json("signal") : Json();
    if (signals.signal() != 0)
        write_table(a.json, "Stopped by a signal: not all frames and repeats.\n");
    if (!a.json.empty() && !write_json(a.json, json)) return exit_not_written;
    return signals.signal() != 0 ? exit_signal + signals.signal() : exit_done;
}

}  // namespace

Action declare_frames(Options& options) {
    auto a = std::make_shared<FramesArguments>();
    options.add("SCENE", a->scenes, "Scene files, or names of `etalon-bench speed --list`")
        .required();
    options.add("-b,--backend", a->plan.backend, "Backend (default: the scene's)")
        .one_of(backend_names());
    options
        .add("--width", a->plan.width,
             "Width of the image in pixels; its height follows (default: the scene's)")
        .within(1, max_image_side);
    options.add("--spp", a->plan.samples, "Number of samples per pixel (default: the scene's)")
        .within(1, 1 << 16);
    options.add("--repeat", a->plan.repeats, "Number of times each stage is measured")
        .within(1, 1000)
        .show_default();
    options.add_flag("--wide", a->wide, "Show all columns, not only those that fit 100 characters");
    options.add("--json", a->json, "Write the results to this JSON file; - is standard output")
        .value("FILE");
    return [a] { return measure_frames(*a); };
}

}  // namespace etalon
