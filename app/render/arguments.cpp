#include "app/render/arguments.h"

#include <fmt/ranges.h>

#include <filesystem>

#include "app/common/backends.h"
#include "app/common/integrators.h"
#include "app/live/tcp_sender.h"
#include "app/render/aovs.h"
#include "app/render/filter_option.h"
#include "core/image/io.h"

namespace etalon {
namespace {

void declare_image(Options& options, RenderArguments& a) {
    const char* group = "Image";
    options
        .add("-o,--output", a.outputs,
             "Output file, FILE.exr or FILE.png, or - for standard output; may be repeated "
             "(default: the scene's name with .exr, in this folder)")
        .value("FILE")
        .check([](const std::string& path) {
            if (path == "-" || can_write(path)) return std::string();
            return path + ": expected a name ending in .exr or .png, or -";
        })
        .one_value_each()
        .group(group);
    options
        .add("--output-format", a.output_format,
             "Format of the image on standard output, for -o - (default: exr)")
        .one_of({"exr", "png"})
        .group(group);
    options
        .add(
            "--resolution", a.resolution,
            "Width and height in pixels; a lens of P3F, which is measured in pixels, becomes wider "
            "with fewer rows (default: the scene's)")
        .value("WxH")
        .group(group);
    options
        .add("--crop", a.crop,
             "Crop window in pixels, without X1 and Y1 themselves (default: the whole image)")
        .value("X0,Y0,X1,Y1")
        .group(group);
    options.add("--filter", a.filter, filter_help())
        .value("NAME[:RADIUS]")
        .check([](const std::string& text) { return check_filter(text); })
        .suggest(filter_names())
        .group(group);
    options
        .add("--aov", a.aovs,
             fmt::format("Comma-separated list of additional channels of the EXR: {}",
                         fmt::join(aov_names(), ", ")))
        .by_commas()
        .check(check_aov)
        .suggest(aov_names())
        .group(group);
    options
        .add_flag("--display-values", a.display_values,
                  "Leave display values, the colours of P3F, NFF, PRT and SCE, as they are in EXR "
                  "and in errors, rather than decode them to linear light")
        .group(group);
    options.add("--exposure", a.exposure, "Exposure of the PNG (default: 0)")
        .value("STOPS")
        .group(group);
}

void declare_samples(Options& options, RenderArguments& a) {
    const char* group = "Samples";
    options
        .add(
            "--spp", a.samples,
            "Number of samples per pixel, the largest with --target-error and --time-limit; 0: one "
            "ray through each pixel's centre (default: the scene's, but 65536 with these two); "
            "path and volpath take up to 16 times as many at the outlines of bright lights")
        .within(0, 1 << 24)
        .group(group);
    options
        .add("--target-error", a.target_error,
             "relMSE, as of `etalon compare`, at which rendering ends; sampling is adaptive "
             "(default: none)")
        .value("E")
        .positive()
        .group(group);
    options.add("--time-limit", a.time_limit, "Time after which rendering ends (default: none)")
        .value("SECONDS")
        .positive()
        .group(group);
    options
        .add("--reference", a.reference,
             "Reference image of the same size; report the error against it over time")
        .value("FILE")
        .group(group);
    options.add("--sampler", a.sampler, "Sample generator (default: sobol)")
        .one_of({"sobol", "random"})
        .group(group);
    options.add("--seed", a.seed, "Random seed, of 64 bits (default: 0)").group(group);
    options
        .add("--part", a.part,
             "The I-th of N equal shares of the samples, counted from 1: an image with more noise, "
             "which `etalon merge` puts together with the others (default: all samples)")
        .value("I/N")
        .excludes("--target-error")
        .excludes("--aov")
        .group(group);
    options
        .add_flag("--spd", a.spd,
                  "Follow the ray rules of the Standard Procedural Databases: one ray through each "
                  "pixel corner, a reflected ray from all glass")
        .excludes("--spp")
        .excludes("--target-error")
        .excludes("--filter")
        .excludes("--part")
        .group(group);
}

/// Returns "Integrator (default: auto, the scene's own); whitted: ..., ao: ...".
std::string integrator_help() {
    std::string text =
        "Integrator, which computes the colour of a sample (default: auto, the scene's own)";
    for (const IntegratorType& type : all_integrators()) {
        text += fmt::format("; {}: {}", type.name, type.summary);
    }
    return text;
}

void declare_rendering(Options& options, RenderArguments& a) {
    const char* group = "Rendering";
    options
        .add("-b,--backend", a.backend,
             "Backend that finds the hits (default: the scene's, else bvh)")
        .one_of(backend_names())
        .group(group);
    options.add("--integrator", a.integrator, integrator_help())
        .one_of(integrator_choices())
        .group(group);
    options
        .add("--max-depth", a.max_depth,
             fmt::format("Maximum path length, including the camera ray, for {} (default: the "
                         "scene's)",
                         fmt::join(integrators_with("--max-depth"), ", ")))
        .within(1, 1000)
        .group(group);
    options
        .add("--max-distance", a.max_distance,
             "Largest distance of an occluder for ao, in units of the scene (default: infinite)")
        .value("D")
        .positive()
        .group(group);
    options.add("-t,--threads", a.threads, "Number of threads (default: all available)")
        .within(1, 4096)
        .group(group);
}

void declare_checkpoint(Options& options, RenderArguments& a) {
    const char* group = "Checkpoints";
    options
        .add("--checkpoint", a.checkpoint,
             "Keep the state of the rendering in this file, from time to time and when a signal or "
             "a time limit ends it")
        .value("FILE")
        .group(group);
    options
        .add("--checkpoint-every", a.checkpoint_every,
             fmt::format("Time between two checkpoints; longer where writing them would take more "
                         "than 2 % of the time (default: {})",
                         usual_checkpoint_interval))
        .value("SECONDS")
        .positive()
        .group(group);
    options
        .add_flag("--resume", a.resume,
                  "Go on from the checkpoint, if there is one: the image is that of a rendering "
                  "that was never stopped")
        .group(group);
}

void declare_mpi(Options& options, RenderArguments& a) {
    options
        .add("--mpi-scene", a.mpi_scene,
             "How the processes that mpirun started get the scene: each reads its files, or rank 0 "
             "reads and sends them, as it does with standard input (default: each)")
        .one_of({"each", "broadcast"})
        .group("MPI");
}

/// Returns why a text is no address of a viewer, and what to do if it is the scene.
std::string check_viewer(const std::string& text) {
    const std::string error = check_address(text);
    std::error_code ignored;
    const bool is_file = !error.empty() && std::filesystem::exists(text, ignored);
    return is_file ? error + "; the scene comes before --tev" : error;
}

void declare_live_view(Options& options, RenderArguments& a) {
    options
        .add("--tev", a.tev,
             "Send the image as it converges to the viewer tev, which listens at this address")
        .value("HOST:PORT")
        .value_or("127.0.0.1:14158")
        .check(check_viewer)
        .group("Live view");
}

}  // namespace

void declare_render_options(Options& options, RenderArguments& a) {
    declare_scene(options, a.scene);
    declare_image(options, a);
    declare_samples(options, a);
    declare_rendering(options, a);
    declare_checkpoint(options, a);
    declare_mpi(options, a);
    declare_live_view(options, a);
    options
        .add("--stats", a.stats,
             "Write counts, times, sizes and errors to this JSON file; - is standard output")
        .value("FILE");
    options.add_flag("-q,--quiet", a.quiet, "Show no progress and no summary");
}

}  // namespace etalon
