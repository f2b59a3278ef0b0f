// etalon crosscheck: traces the same rays with several backends and the oracle.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/common/backends.h"
#include "app/common/exit_status.h"
#include "app/common/fail.h"
#include "app/common/output.h"
#include "app/common/progress.h"
#include "app/common/signals.h"
#include "app/crosscheck/crosscheck_report.h"
#include "app/replaced_images.h"
#include "app/scene_arguments.h"
#include "app/subcommands.h"

namespace etalon {
namespace {

struct Arguments {
    SceneArguments scene;
    crosscheck::CrosscheckConfig config{backend_names()};
    std::string json, rays_out;
};

/// Writes the tables to standard error if another program reads standard output.
void print(const Arguments& a, const crosscheck::Results& results) {
    const std::string output = a.rays_out == "-" ? a.rays_out : a.json;
    write_table(output, crosscheck::as_text(results));
    if (a.config.worst > 0 && a.rays_out != "-") {
        write_table(output, fmt::format("\n{}", crosscheck::as_rays(results)));
    }
}

crosscheck::Results crosscheck_scene(const Arguments& a, const LoadedScene& loaded,
                                     const std::atomic<bool>& stop) {
    std::optional<Progress> progress;
    const crosscheck::CrosscheckProgress run{
        stop, [&](const std::string& stage) { progress.emplace(a.scene.path + ": " + stage); },
        [&](double part) { progress->update(part); }};
    return crosscheck::crosscheck(*loaded.scene, loaded.settings.resolution, a.config, run);
}

bool write(const Arguments& a, const crosscheck::Results& results) {
    print(a, results);
    if (!a.json.empty() && !write_json(a.json, crosscheck::as_json(results))) return false;
    return a.rays_out.empty() || write_text(a.rays_out, crosscheck::as_rays(results));
}

int run(const Arguments& a) {
    if (const auto [error, status] = check_outputs({a.json, a.rays_out}, {a.scene.path});
        !error.empty()) {
        return fail(status, error);
    }
    LoadedScene loaded = load(a.scene);
    if (!loaded.scene) return loaded.status;
    if (refuse_outputs({a.json, a.rays_out}, loaded.files)) return exit_usage;
    if (!make_cut_outs(*loaded.scene, a.scene)) return exit_unusable;
    const SignalGuard signals;
    const crosscheck::Results results = crosscheck_scene(a, loaded, signals.raised());
    const bool written = write(a, results);
    if (signals.signal() != 0) return exit_signal + signals.signal();
    if (!written) return exit_not_written;
    return results.as_promised() ? exit_done : exit_differs;
}

}  // namespace

Action declare_crosscheck(Options& options) {
    auto a = std::make_shared<Arguments>();
    declare_scene(options, a->scene);
    options
        .add("-b,--backend", a->config.backends,
             "Comma-separated list of backends; errors of embree-builtin do not "
             "change the exit status")
        .by_commas()
        .one_of(backend_names())
        .show_default();
    options
        .add("--rays", a->config.rays, "Number of rays of each kind: camera, bounce, shadow, aimed")
        .within(std::size_t{1}, std::size_t{1} << 24)
        .show_default();
    options.add("--worst", a->config.worst, "Number of each backend's worst rays to list")
        .within(std::size_t{0}, std::size_t{1} << 24)
        .show_default();
    options.add("--json", a->json, "Write the results to this JSON file; - is standard output")
        .value("FILE");
    options
        .add("--rays-out", a->rays_out,
             "Write the worst rays to this file, for trace --rays; - is standard output")
        .value("FILE");
    return [a] { return run(*a); };
}

}  // namespace etalon
