// etalon-bench convergence: how soon a picture comes to what it should be, by samplers and
// backends.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/backends.h"
#include "app/exit_status.h"
#include "app/output.h"
#include "app/progress.h"
#include "app/reference_picture.h"
#include "app/signals.h"
#include "bench/commands.h"
#include "bench/convergence/measure.h"
#include "bench/convergence/report.h"
#include "bench/scenes/bench_scene.h"
#include "bench/speed/report/json.h"

namespace etalon {
namespace {

using namespace convergence;

struct Arguments {
    std::string scene, reference, json;
    int width = 0;
    Plan plan;
};

int fail(int status, const std::string& message) {
    fmt::print(stderr, "etalon-bench: error: {}\n", message);
    return status;
}

/// The height follows.
void set_width(Camera& camera, int width) {
    if (width == 0) return;
    camera.height = std::max(1, (camera.height * width + camera.width / 2) / camera.width);
    camera.width = width;
}

Outcome<Truth> read_truth(const std::string& path, const Scene& scene) {
    const Camera& camera = scene.camera;
    auto picture = read_reference(path, scene, {{0, 0}, {camera.width - 1, camera.height - 1}});
    return {{std::move(picture.value), path}, picture.error};
}

/// Tables make room for JSON that another program is to read from standard output.
void show(const Arguments& a, const std::string& text) {
    fmt::print(a.json == "-" ? stderr : stdout, "{}", text);
}

nlohmann::ordered_json report_on(const Arguments& a, const Scene& scene, const Truth& truth,
                                 const std::vector<Curve>& curves) {
    nlohmann::ordered_json json = speed::json_of_machine();
    json["scene"] = a.scene;
    json["image"] = {{"width", scene.camera.width}, {"height", scene.camera.height}};
    json["reference"] = truth.description;
    json["seeds"] = a.plan.seeds;
    json["curves"] = nlohmann::ordered_json::array();
    show(a, fmt::format("{}, {} x {}; reference: {}; {} seeds\n\n", a.scene, scene.camera.width,
                        scene.camera.height, truth.description, a.plan.seeds));
    for (const Curve& curve : curves) {
        show(a, table(curve) + "\n");
        json["curves"].push_back(json_of(curve));
    }
    return json;
}

int run(const Arguments& a) {
    const std::string obstacle = a.json.empty() || a.json == "-" ? "" : obstacle_to_writing(a.json);
    if (!obstacle.empty()) return fail(exit_not_written, obstacle);
    bench::NamedScene named = bench::bench_scene(a.scene);
    fmt::print(stderr, "{}", named.messages);
    if (!named.scene) return exit_unusable;
    set_width(named.scene->camera, a.width);
    const SignalGuard signals;
    Progress progress(a.scene);
    const Watcher watcher{signals.raised(), [&](double part) { progress.update(part); }};
    const Outcome<Truth> truth =
        a.reference.empty() ? Outcome<Truth>{render_truth(*named.scene, a.plan, watcher), {}}
                            : read_truth(a.reference, *named.scene);
    if (!truth) return fail(exit_unusable, truth.error);
    const std::vector<Curve> curves = measure(*named.scene, truth.value, a.plan, watcher);
    const auto json = report_on(a, *named.scene, truth.value, curves);
    if (!a.json.empty() && !write_json(a.json, json)) return exit_not_written;
    return signals.signal() != 0 ? exit_signal + signals.signal() : exit_done;
}

}  // namespace

Action declare_convergence(Options& options) {
    auto a = std::make_shared<Arguments>();
    options.add("SCENE", a->scene, "A file, or a name as `etalon-bench speed --list` has them")
        .required();
    options.add("--reference", a->reference,
                "The picture as it should be (default: rendered, with 32 times the samples)");
    options.add("--samplers", a->plan.samplers, "Which, by commas; the first backend's curves")
        .by_commas()
        .one_of(sampler_names())
        .show_default();
    options.add("--integrators", a->plan.integrators, "Which, by commas")
        .by_commas()
        .one_of({"whitted"})
        .show_default();
    options
        .add("--backends", a->plan.backends,
             "Which, by commas; those after the first take "
             "the last sampler")
        .by_commas()
        .one_of(backend_names())
        .show_default();
    options.add("--spp", a->plan.samples, "Samples per pixel at the end of a curve")
        .within(4, 1 << 16)
        .show_default();
    options.add("--seeds", a->plan.seeds, "Pictures for each curve").within(1, 1000).show_default();
    options.add("--width", a->width, "Of the picture; its height follows (default: the scene's)")
        .within(1, 65536);
    options.add("--json", a->json, "Write the figures to this file; - is standard output");
    return [a] { return run(*a); };
}

}  // namespace etalon
