#include "bench/frames/measure_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/common/console.h"
#include "app/common/stand_ins.h"
#include "app/common/stopwatch.h"
#include "bench/frames/frame.h"
#include "bench/scenes/bench_scene.h"
#include "bench/speed/alternate.h"
#include "core/intersect/backend_roles.h"
#include "core/parallel/parallel.h"

namespace etalon::frames {
namespace {

/// Approximate number of rays of a scene that are recorded to be traced again.
constexpr std::uint64_t recorded_rays = 2'000'000;

using Frames = std::vector<std::unique_ptr<Frame>>;

/// Returns a frame for each backend of the config. All together record no more rays than one alone.
Frames frames_of(const Scene& scene, RenderSettings settings, const FrameConfig& config) {
    Frames frames;
    std::vector<std::string> backends = config.backends;
    if (backends.empty()) backends.push_back(settings.backend);
    for (const std::string& backend : backends) {
        settings.backend = backend;
        frames.push_back(
            std::make_unique<Frame>(scene, settings, config, recorded_rays / backends.size()));
    }
    return frames;
}

/// Measures all frames alternately, until it is over; returns an error message, or nothing.
std::string repeat(const Frames& frames, const FrameConfig& config) {
    std::string error;
    const auto is_over = [&] { return config.is_over() || !error.empty(); };
    speed::alternate(config.repeats, frames.size(), is_over,
                     [&](int, std::size_t k) { error = frames[k]->measure_again(config); });
    return error;
}

std::vector<FrameFigures> figures_of(const Frames& frames) {
    std::vector<FrameFigures> all;
    for (const auto& frame : frames) {
        if (frame->has_repeats()) all.push_back(frame->figures());
    }
    const auto found = std::ranges::find(all, baseline_backend, &FrameFigures::backend);
    const auto baseline = found == all.end() ? all.begin() : found;
    for (FrameFigures& f : all) f.ratio = baseline->render / f.render;
    return all;
}

}  // namespace

Result<std::vector<FrameFigures>> measure_frame(const std::string& name,
                                                const FrameConfig& config) {
    Stopwatch watch;
    bench::NamedScene named = bench::bench_scene(name);
    const double load = watch.lap().cpu;
    write_message(named.messages);
    if (!named.scene) return {{}, fmt::format("{}: no scene to measure", name)};
    const std::string clash = config.check_files ? config.check_files(named.files) : "";
    if (!clash.empty()) return {{}, clash};
    bench::set_width(named.settings, config.width);
    if (config.samples > 0) named.settings.samples_per_pixel = config.samples;
    const ThreadLimit one_thread(1);
    const Frames frames = frames_of(*named.scene, named.settings, config);
    write_message(stand_in_warnings(*named.scene, name, frames.front()->problems()));
    const std::string error = repeat(frames, config);
    if (!error.empty()) return {{}, error};
    std::vector<FrameFigures> all = figures_of(frames);
    for (FrameFigures& f : all) {
        f.scene = name;
        f.load = load;
    }
    return {std::move(all), {}};
}

}  // namespace etalon::frames
