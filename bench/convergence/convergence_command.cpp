// etalon-bench convergence: how soon an image comes to what it should be, by samplers and
// backends.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/common/backends.h"
#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/integrators.h"
#include "app/common/output.h"
#include "app/common/progress.h"
#include "app/common/progress_line.h"
#include "app/common/provenance.h"
#include "app/common/reference_image.h"
#include "app/common/signals.h"
#include "bench/bench_subcommands.h"
#include "bench/convergence/curve_report.h"
#include "bench/convergence/measure_curves.h"
#include "bench/scenes/bench_scene.h"

namespace etalon {
namespace {

using namespace convergence;

using Json = nlohmann::ordered_json;

struct ConvergenceArguments {
    std::string scene, reference, json;
    int width = 0;
    std::vector<std::string> integrators{std::string(scene_integrator)};
    Plan plan;
};

int fail(int status, const std::string& message) {
    print_message("etalon-bench: error: {}\n", message);
    return status;
}

/// Results of one integrator, or of all.
struct Measured {
    std::string reference;  ///< what the curves are compared with
    std::vector<Curve> curves;
};

Result<ReferenceImage> read_reference_image(const std::string& path,
                                            const RenderSettings& settings) {
    auto image = read_reference(path, settings);
    return {{std::move(image.value), path}, image.error};
}

Json report_on(const ConvergenceArguments& a, const Imath::V2i& size, const Measured& measured,
               bool stopped) {
    Json json = provenance();
    json["stopped"] = stopped ? Json("signal") : Json();
    json["scene"] = a.scene;
    json["image"] = {{"width", size.x}, {"height", size.y}};
    json["reference"] = measured.reference;
    json["seeds"] = a.plan.seeds;
    json["curves"] = Json::array();
    constexpr int name_width = 40;
    write_table(a.json, fmt::format("{}, {} x {}; reference: {}; {} seeds\n\n",
                                    shortened(a.scene, name_width), size.x, size.y,
                                    shortened(measured.reference, name_width - 10), a.plan.seeds));
    for (const Curve& curve : measured.curves) {
        write_table(a.json, table_of(curve) + "\n");
        json["curves"].push_back(json_of(curve));
    }
    if (stopped) write_table(a.json, "Stopped by a signal: not all curves.\n");
    write_table(a.json, legend());
    return json;
}

/// The reference and the curves of one integrator.
Result<Measured> measure_integrator(const ConvergenceArguments& a, const bench::NamedScene& named,
                                    const RenderSettings& settings, const RunProgress& run) {
    Result<ReferenceImage> reference =
        a.reference.empty()
            ? Result<ReferenceImage>{render_reference(*named.scene, settings, a.plan, run), {}}
            : read_reference_image(a.reference, settings);
    if (!reference) return {{}, reference.error};
    Measured measured{reference.value.description, {}};
    measured.curves = measure(*named.scene, settings, reference.value, a.plan, run);
    return {std::move(measured), {}};
}

int measure_convergence(const ConvergenceArguments& a) {
    const std::string error = a.json.empty() || a.json == "-" ? "" : check_writable(a.json);
    if (!error.empty()) return fail(exit_not_written, error);
    bench::NamedScene named = bench::bench_scene(a.scene);
    write_message(named.messages);
    if (!named.scene) return exit_unusable;
    bench::set_width(named.settings.resolution, a.width);
    const SignalGuard signals;
    Progress progress(a.scene);
    Measured all;
    const auto count = static_cast<double>(a.integrators.size());
    for (std::size_t i = 0; i < a.integrators.size() && signals.signal() == 0; ++i) {
        const auto done = static_cast<double>(i);
        const RunProgress run{signals.raised(),
                              [&](double part) { progress.update((done + part) / count); }};
        bench::NamedScene scene = named;
        RenderSettings& settings = scene.settings;
        choose_integrator(a.integrators[i], settings);
        if (!find_integrator(settings.integrator)->renders(*named.scene)) {
            return fail(exit_usage, fmt::format("--integrators: {} cannot render a {} scene; "
                                                "expected {}",
                                                settings.integrator, named.scene->format,
                                                fmt::join(integrators_for(*named.scene), " or ")));
        }
        prepare_scene(a.integrators[i], *scene.scene, settings);
        Result<Measured> one = measure_integrator(a, scene, settings, run);
        if (!one) return fail(exit_unusable, one.error);
        all.reference = one.value.reference;
        std::ranges::move(one.value.curves, std::back_inserter(all.curves));
    }
    const auto json = report_on(a, named.settings.resolution, all, signals.signal() != 0);
    if (!a.json.empty() && !write_json(a.json, json)) return exit_not_written;
    return signals.signal() != 0 ? exit_signal + signals.signal() : exit_done;
}

}  // namespace

Action declare_convergence(Options& options) {
    auto a = std::make_shared<ConvergenceArguments>();
    options.add("SCENE", a->scene, "Scene file, or a name of `etalon-bench speed --list`")
        .required();
    options
        .add("--reference", a->reference,
             "Reference image (default: rendered, with 32 times the samples)")
        .value("FILE");
    options
        .add("--samplers", a->plan.samplers,
             "Comma-separated list of samplers, all with the first backend")
        .by_commas()
        .one_of(sampler_names())
        .show_default();
    options
        .add("--integrators", a->integrators,
             "Comma-separated list of integrators, each with curves of its own and, without "
             "--reference, a reference of its own; auto: the scene's")
        .by_commas()
        .one_of(integrator_choices())
        .show_default();
    options
        .add("--backends", a->plan.backends,
             "Comma-separated list of backends; those after the first only with "
             "the last sampler")
        .by_commas()
        .one_of(backend_names())
        .show_default();
    options.add("--spp", a->plan.samples, "Number of samples per pixel at the end of a curve")
        .within(4, 1 << 16)
        .show_default();
    options.add("--seeds", a->plan.seeds, "Number of images, of different seeds, for each curve")
        .within(1, 1000)
        .show_default();
    options
        .add("--width", a->width,
             "Width of the image in pixels; its height follows (default: the scene's)")
        .within(1, 65536);
    options.add("--json", a->json, "Write the results to this JSON file; - is standard output")
        .value("FILE");
    return [a] { return measure_convergence(*a); };
}

}  // namespace etalon
