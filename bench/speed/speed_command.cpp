// etalon-bench speed: rays per second, build time and memory of each backend, with its errors on
// the same rays.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/fail.h"
#include "app/common/joined_words.h"
#include "app/common/output.h"
#include "app/common/progress_line.h"
#include "app/common/signals.h"
#include "bench/bench_subcommands.h"
#include "bench/scenes/bench_scene.h"
#include "bench/speed/measured_scene.h"
#include "bench/speed/pinned.h"
#include "bench/speed/report/speed_json.h"
#include "bench/speed/report/speed_table.h"
#include "bench/speed/timed_tracer.h"
#include "core/test_rays/ray_sets.h"

namespace etalon {
namespace {

using namespace speed;

/// The reference tests every primitive against every ray, so it is measured only on request.
std::vector<std::string> usual_tracers() {
    std::vector<std::string> names = tracer_names();
    std::erase(names, reference_backend);
    return names;
}

struct SpeedArguments {
    std::vector<std::string> scenes{"terrain", "flake",        "soup",   "stadium",
                                    "slivers", "spheres:1000", "spheres"};
    std::vector<std::string> backends = usual_tracers();
    std::vector<std::string> kinds{"camera", "bounce", "shadow", "random"};
    std::vector<int> threads{1};
    int repeats = 5;
    std::size_t max_rays = 1 << 18;
    double oracle_seconds = 1;
    bool only_build = false, list = false, wide = false;
    std::string json;

    Detail detail() const { return wide ? Detail::wide : Detail::narrow; }

    SpeedConfig config() const {
        std::set<int> counts(threads.begin(), threads.end());
        counts.insert(1);
        return {with_baselines(backends),
                {counts.begin(), counts.end()},
                repeats,
                oracle_seconds,
                only_build ? std::vector<std::string>() : kinds,
                max_rays};
    }
};

/// Returns the table of what was measured last, the first one of rays with its heading.
std::string table_of(const SceneFigures& figures, Detail detail) {
    if (figures.kinds.empty()) return table_of(figures.builds, detail);
    return (figures.kinds.size() == 1 ? heading_of_rays(detail) : "") +
           table_of(figures.kinds.back(), detail);
}

/// Returns what the columns of all tables mean.
std::string legend_of(const SpeedArguments& a) {
    table::Legend legend;
    explain_builds(a.detail(), legend);
    if (!a.only_build) {
        explain_rays(a.detail(), legend);
        explain_means(legend);
    }
    return legend.text();
}

/// Names the tracers that are Etalon's own kernels in disguise for this scene: comparisons with
/// them say nothing about Embree's.
void note_borrowed_kernels(const SpeedArguments& a, const Geometry& geometry) {
    for (const std::string& name : a.config().tracers) {
        const Backend& backend = find_tracer(name);
        if (!backend.has_own_kernels || backend.has_own_kernels(geometry)) continue;
        write_table(a.json, fmt::format("{} has no kernels for these shapes: it calls Etalon's\n",
                                        backend.name));
    }
}

/// Names the kinds of rays that were requested and of which the scene has none.
void note_missing_kinds(const SpeedArguments& a, const SceneFigures& figures) {
    for (const std::string& kind : a.config().kinds) {
        if (std::ranges::find(figures.kinds, kind, &KindFigures::kind) != figures.kinds.end()) {
            continue;
        }
        write_table(a.json, fmt::format("no {} rays: no surface or no light\n", kind));
    }
}

SceneFigures measure(const SpeedArguments& a, const std::string& name, Scene scene,
                     const Imath::V2i& resolution, const std::atomic<bool>& stop) {
    constexpr int name_width = 70;
    write_table(a.json, fmt::format("{}: {} primitives\n", shortened(name, name_width),
                                    scene.geometry.item_count()));
    note_borrowed_kernels(a, scene.geometry);
    const auto show = [&](const SceneFigures& figures) {
        write_table(a.json, table_of(figures, a.detail()));
    };
    const auto is_over = [&] { return stop.load(); };
    SceneFigures figures =
        measure_scene(name, std::move(scene), resolution, a.config(), {show, is_over});
    if (!is_over()) note_missing_kinds(a, figures);
    write_table(a.json, (figures.kinds.empty() ? "" : table_of_means(figures)) + "\n");
    return figures;
}

/// Checks all names before anything is measured, so that an error in the last one costs no time.
int check_arguments(const SpeedArguments& a) {
    std::string messages;
    for (const std::string& name : a.scenes) {
        const std::string error = bench::check_scene_name(name);
        if (!error.empty()) messages += "etalon-bench: error: " + error + "\n";
    }
    write_message(messages);
    if (!messages.empty()) return exit_unusable;
    const auto [error, status] = check_outputs({a.json}, a.scenes);
    return error.empty() ? exit_done : fail(status, error);
}

/// Writes the file after every scene, so that a run that ends in any way keeps its results. Until
/// the last scene it says "error", for ends of which nothing more can be written.
bool save(const SpeedArguments& a, nlohmann::ordered_json& json, bool is_last) {
    json["stopped"] = is_last ? nlohmann::ordered_json() : nlohmann::ordered_json("error");
    if (a.json.empty() || (!is_last && !is_replaceable(a.json))) return true;
    return write_json(a.json, json);
}

/// Keeps finished results, marked as partial, and says why they are.
void save_part(const SpeedArguments& a, nlohmann::ordered_json& json, const char* stopped,
               const std::string& why) {
    json["stopped"] = stopped;
    write_table(a.json, why + "\n");
    if (!a.json.empty()) write_json(a.json, json);
}

int measure_speed(const SpeedArguments& a) {
    if (a.list) return write_result(bench::list_of_scenes()), exit_done;
    if (const int status = check_arguments(a); status != exit_done) return status;
    const SignalGuard signals;
    nlohmann::ordered_json json = json_of_environment(a.config());
    json["stopped"] = nullptr;
    json["scenes"] = nlohmann::ordered_json::array();
    for (const std::string& name : a.scenes) {
        bench::NamedScene named = bench::bench_scene(name);
        write_message(named.messages);
        if (!named.scene) {
            save_part(a, json, "error", "Ended at a scene that cannot be read: " + name);
            return exit_unusable;
        }
        if (const std::string clash = find_clash({a.json}, named.files); !clash.empty()) {
            return fail(exit_usage, clash);
        }
        const SceneFigures figures =
            measure(a, name, std::move(*named.scene), named.settings.resolution, signals.raised());
        if (!figures.builds.empty()) json["scenes"].push_back(json_of(figures));
        const bool is_last = signals.raised() || &name == &a.scenes.back();
        if (is_last) write_table(a.json, legend_of(a));
        if (signals.raised()) {
            save_part(a, json, "signal",
                      fmt::format("Stopped by a signal in {}.", shortened(name, 70)));
            return exit_signal + signals.signal();
        }
        if (!save(a, json, is_last)) return exit_not_written;
    }
    return exit_done;
}

void declare_what(Options& options, SpeedArguments& a) {
    options
        .add("--scene", a.scenes,
             "Comma-separated list of scenes: names of --list, with or without :SIZE, or files")
        .value("SCENE")
        .words_by_commas()
        .show_default();
    options
        .add("-b,--backends", a.backends,
             "Comma-separated list of backends; the baselines of all comparisons always take part")
        .by_commas()
        .one_of(tracer_names())
        .show_default();
    options.add("--rays", a.kinds, "Comma-separated list of the kinds of rays")
        .by_commas()
        .one_of(std::vector<std::string>(ray_kinds.begin(), ray_kinds.end()))
        .show_default();
    options.add_flag("--list", a.list, "List the named scenes and exit");
    options.add_flag("--only-build", a.only_build, "Measure builds only; trace no rays");
}

void declare_how(Options& options, SpeedArguments& a) {
    options
        .add("--threads", a.threads,
             "Comma-separated list of numbers of threads; 1 is measured always")
        .by_commas()
        .within(1, usable_cores())
        .show_default();
    options.add("--repeat", a.repeats, "Number of alternating repeats, of which the medians count")
        .within(1, 1000)
        .show_default();
    options.add("--max-rays", a.max_rays, "Approximate largest number of rays of each kind")
        .within(std::size_t{1}, std::size_t{1} << 28)
        .show_default();
    options
        .add("--oracle", a.oracle_seconds,
             "CPU time for the oracle to check a sample of each kind of ray, and as "
             "much again for rays in dispute")
        .value("SECONDS")
        .not_negative()
        .show_default();
    options.add_flag("--wide", a.wide, "Show all columns, not only those that fit 100 characters");
    options.add("--json", a.json, "Write the results to this JSON file; - is standard output")
        .value("FILE");
}

}  // namespace

Action declare_speed(Options& options) {
    auto a = std::make_shared<SpeedArguments>();
    declare_what(options, *a);
    declare_how(options, *a);
    return [a] {
        a->scenes = joined_words(a->scenes, [](const std::string& name) {
            return bench::check_scene_name(name).empty();
        });
        return measure_speed(*a);
    };
}

}  // namespace etalon
