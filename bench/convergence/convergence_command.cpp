// etalon-bench convergence: the error of an image against CPU time, by sampler and backend,
// compared with images of other programs.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "app/common/backends.h"
#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/fail.h"
#include "app/common/integrators.h"
#include "app/common/output.h"
#include "app/common/program_facts.h"
#include "app/common/progress.h"
#include "app/common/reference_image.h"
#include "app/common/signals.h"
#include "app/common/stand_ins.h"
#include "app/common/stopwatch.h"
#include "bench/bench_subcommands.h"
#include "bench/convergence/convergence_results.h"
#include "bench/convergence/measure_foreign.h"
#include "bench/frames/process_start.h"
#include "bench/scenes/bench_scene.h"
#include "core/base/read_log.h"
#include "core/scene/resize.h"

namespace etalon {
namespace {

using namespace convergence;

struct ConvergenceArguments {
    std::string scene, reference, foreign, json, csv;
    int width = 0;
    std::vector<std::string> integrators{std::string(scene_integrator)};
    ConvergenceConfig config;
};

Result<ReferenceImage> read_reference_image(const std::string& path,
                                            const RenderSettings& settings) {
    auto image = read_reference(path, settings);
    return {{std::move(image.value), path}, image.error};
}

/// Reads images of the scene by other programs, and their reference if the command line has none.
Result<std::vector<ForeignImage>> read_foreign_images(ConvergenceArguments& a) {
    Result<std::vector<ForeignImage>> all = read_foreign_table(a.foreign);
    if (!all) return all;
    std::vector<ForeignImage> images = images_of(all.value, a.scene);
    if (images.empty()) return {{}, fmt::format("{}: error: no image of {}", a.foreign, a.scene)};
    if (a.reference.empty()) a.reference = reference_for(images, a.scene);
    if (!a.reference.empty()) return {std::move(images), {}};
    return {{},
            fmt::format("{}: error: no reference of {}; expected --reference, or one in the table",
                        a.foreign, a.scene)};
}

/// Adds the reference and the curves of one integrator, each when it is done; returns an error
/// message, or nothing.
std::string measure_integrator(const ConvergenceArguments& a, const bench::NamedScene& named,
                               RunProgress run, Measured& all) {
    Result<ReferenceImage> reference =
        a.reference.empty()
            ? Result<ReferenceImage>{render_reference(*named.scene, named.settings, a.config, run),
                                     {}}
            : read_reference_image(a.reference, named.settings);
    if (!reference) return reference.error;
    all.reference = reference.value.description;
    run.after_curve = [&](const convergence::Curve& curve) {
        all.curves.push_back(curve);
        keep_results(all, a.json, a.csv);
    };
    measure(*named.scene, named.settings, reference.value, a.config, run);
    return {};
}

/// Measures the images of other programs against the reference and adds them; returns an error
/// message, or nothing.
std::string measure_foreign_images(ConvergenceArguments& a, const RenderSettings& settings,
                                   Measured& measured) {
    const Result<std::vector<ForeignImage>> images = read_foreign_images(a);
    if (!images) return images.error;
    const Result<ReferenceImage> reference = read_reference_image(a.reference, settings);
    if (!reference) return fmt::format("{}: error: {}", program_name(), reference.error);
    Result<std::vector<ForeignCurve>> curves =
        measure_foreign(images.value, reference.value, settings);
    measured.foreign = std::move(curves.value);
    measured.reference = reference.value.description;
    return curves.error;
}

/// Returns why one of the integrators cannot render the scene; empty if all can.
std::string check_integrators(const ConvergenceArguments& a, const bench::NamedScene& named) {
    for (const std::string& name : a.integrators) {
        RenderSettings settings = named.settings;
        choose_integrator(name, settings);
        if (find_integrator(settings.integrator)->renders(*named.scene)) continue;
        return fmt::format("--integrators: {} cannot render a {} scene; expected {}",
                           settings.integrator, named.scene->format,
                           fmt::join(integrators_for(*named.scene), " or "));
    }
    return {};
}

/// Adds the curves of all integrators until a stop; returns an error message, or nothing.
std::string measure_integrators(const ConvergenceArguments& a, const bench::NamedScene& named,
                                const std::atomic<bool>& stop, Measured& all) {
    Progress progress(a.scene);
    const auto count = static_cast<double>(a.integrators.size());
    for (std::size_t i = 0; i < a.integrators.size() && !stop; ++i) {
        const auto done = static_cast<double>(i);
        RunProgress run{stop, [&](double part) { progress.update((done + part) / count); }};
        bench::NamedScene scene = named;
        choose_integrator(a.integrators[i], scene.settings);
        prepare_scene(a.integrators[i], *scene.scene, scene.settings);
        std::string error = measure_integrator(a, scene, std::move(run), all);
        if (!error.empty()) return error;
    }
    return {};
}

void warn_of_replaced_images(const ConvergenceArguments& a, const Scene& scene,
                             const Measured& measured) {
    std::vector<std::string> problems;
    for (const auto& curve : measured.curves) {
        std::ranges::copy(curve.replaced_images, std::back_inserter(problems));
    }
    write_message(stand_in_warnings(scene, a.scene, problems));
}

/// Returns that an output would replace a file that was read or belongs to the scene; empty if none
/// would.
std::string find_lost(const ConvergenceArguments& a, const ReadLog& read,
                      std::vector<std::string> scene_files) {
    std::ranges::copy(read.paths(), std::back_inserter(scene_files));
    return find_clash({a.json, a.csv}, scene_files);
}

int measure_convergence(ConvergenceArguments a) {
    const auto [error, status] = check_outputs({a.json, a.csv}, {a.scene, a.reference, a.foreign});
    if (!error.empty()) return fail(status, error);
    const ReadLog read(ReadLog::Keeps::paths);
    Stopwatch reading;
    bench::NamedScene named = bench::bench_scene(a.scene);
    a.config.reading_seconds = frames::seconds_before_main() + reading.lap().cpu;
    write_message(named.messages);
    if (!named.scene) return exit_unusable;
    const std::string unfit = check_integrators(a, named);
    if (!unfit.empty()) return fail(exit_usage, unfit);
    bench::set_width(named.settings, a.width);
    Measured all{a.scene, named.settings.resolution, a.config.seeds};
    if (!a.foreign.empty()) {
        const std::string why = measure_foreign_images(a, named.settings, all);
        write_message(why.empty() ? "" : why + "\n");
        if (!why.empty()) return exit_unusable;
    }
    const std::string lost = find_lost(a, read, named.files);
    if (!lost.empty()) return fail(exit_usage, lost);
    const SignalGuard signals;
    const std::string why = measure_integrators(a, named, signals.raised(), all);
    if (!why.empty()) return fail(exit_unusable, why);
    warn_of_replaced_images(a, *named.scene, all);
    const bool is_stopped = signals.signal() != 0;
    if (is_stopped) all.stopped = "signal";
    if (!write_results(all, a.json, a.csv)) return exit_not_written;
    return is_stopped ? exit_signal + signals.signal() : exit_done;
}

void declare_inputs(Options& options, ConvergenceArguments& a) {
    options.add("SCENE", a.scene, "Scene file, or a name of `etalon-bench speed --list`")
        .required();
    options
        .add("--reference", a.reference,
             "Reference image (default: rendered, with 32 times the samples)")
        .value("FILE");
    options
        .add("--foreign", a.foreign,
             "Compare with the images of other programs in this table of tab-separated values; "
             "docs/convergence.md says what it holds. Its reference, or the one beside the scene, "
             "serves without --reference")
        .value("TABLE");
}

void declare_curves(Options& options, ConvergenceArguments& a) {
    options
        .add("--samplers", a.config.samplers,
             "Comma-separated list of samplers, all with the first backend")
        .by_commas()
        .one_of(sampler_names())
        .show_default();
    options
        .add("--integrators", a.integrators,
             "Comma-separated list of integrators, each with curves of its own and, without "
             "--reference, a reference of its own; auto: the scene's")
        .by_commas()
        .one_of(integrator_choices())
        .show_default();
    options
        .add("-b,--backends", a.config.backends,
             "Comma-separated list of backends; those after the first only with "
             "the last sampler")
        .by_commas()
        .one_of(backend_names())
        .show_default();
    options.add("--spp", a.config.samples, "Number of samples per pixel at the end of a curve")
        .within(4, 1 << 16)
        .show_default();
    options.add("--seeds", a.config.seeds, "Number of images, of different seeds, for each curve")
        .within(1, 1000)
        .show_default();
    options
        .add("--width", a.width,
             "Width of the image in pixels; its height follows (default: the scene's)")
        .within(1, max_image_side);
}

void declare_outputs(Options& options, ConvergenceArguments& a) {
    options.add("--json", a.json, "Write the results to this JSON file; - is standard output")
        .value("FILE");
    options
        .add("--csv", a.csv,
             "Write the points of all curves to this CSV file; - is standard output")
        .value("FILE");
}

}  // namespace

Action declare_convergence(Options& options) {
    auto a = std::make_shared<ConvergenceArguments>();
    declare_inputs(options, *a);
    declare_curves(options, *a);
    declare_outputs(options, *a);
    return [a] { return measure_convergence(*a); };
}

}  // namespace etalon
