#include "app/render/arguments.h"

#include <fmt/core.h>

#include "app/backends.h"
#include "app/integrators.h"
#include "app/render/aovs.h"
#include "core/image/io.h"

namespace etalon {
namespace {

void declare_picture(CLI::App& app, RenderArguments& a) {
    const char* group = "Picture";
    app.add_option("-o,--output", a.outputs,
                   "FILE.exr or FILE.png; may be repeated "
                   "(default: the scene's name with .exr, in this folder)")
        ->check([](const std::string& path) {
            return can_write(path) ? "" : path + ": expected a name ending in .exr or .png";
        })
        ->allow_extra_args(false)
        ->group(group);
    app.add_option("--resolution", a.resolution, "WIDTHxHEIGHT instead of the scene's")
        ->group(group);
    app.add_option("--crop", a.crop, "X0,Y0,X1,Y1: only these pixels, half open")->group(group);
    app.add_option("--aov", a.aovs,
                   "NAME,...: channels of the EXR beside the colours: " + aov_names())
        ->delimiter(',')
        ->check(check_aov)
        ->group(group);
    app.add_option("--exposure", a.exposure, "Stops, for PNG only")->group(group);
}

void declare_samples(CLI::App& app, RenderArguments& a) {
    const char* group = "Samples";
    app.add_option("--spp", a.samples,
                   "Samples per pixel, at most; 0: one ray through each pixel's centre "
                   "(default: the scene's, but 65536 with --target-error or --time-limit)")
        ->check(CLI::Range(0, 1 << 24))
        ->group(group);
    app.add_option(
           "--target-error", a.target_error,
           "relMSE, as `etalon compare` has it, at which the picture is good enough; samples "
           "go where they help most")
        ->check(CLI::PositiveNumber)
        ->group(group);
    app.add_option("--time-limit", a.time_limit, "Seconds of rendering after which it ends")
        ->check(CLI::PositiveNumber)
        ->group(group);
    app.add_option("--reference", a.reference,
                   "A picture of the same size: say how far from it this one is, and at what time")
        ->group(group);
    app.add_option("--sampler", a.sampler, "sobol, or random to compare with")
        ->check(CLI::IsMember({"sobol", "random"}))
        ->group(group);
    app.add_option("--seed", a.seed, "Of the sample points")->group(group);
    app.add_flag("--spd", a.spd,
                 "Count rays by the rules of the Standard Procedural Databases: one through each "
                 "pixel corner, a mirrored one from all glass")
        ->excludes("--spp")
        ->excludes("--target-error")
        ->group(group);
}

/// "Integrator (default: auto, the scene's own); whitted: ..., ao: ...".
std::string integrator_help() {
    std::string text = "How the colour of a sample is computed (default: auto, the scene's own)";
    for (const IntegratorType& type : all_integrators()) {
        text += fmt::format("; {}: {}", type.name, type.summary);
    }
    return text;
}

void declare_rendering(CLI::App& app, RenderArguments& a) {
    const char* group = "Rendering";
    app.add_option("-b,--backend", a.backend, "How hits are found (default: the scene's, else bvh)")
        ->check(CLI::IsMember(backend_names()))
        ->group(group);
    app.add_option("--integrator", a.integrator, integrator_help())
        ->check(CLI::IsMember(integrator_choices()))
        ->group(group);
    app.add_option(
           "--max-depth", a.max_depth,
           "Maximum path length of whitted, including the camera ray (default: the scene's)")
        ->check(CLI::Range(1, 1000))
        ->group(group);
    app.add_option("--max-distance", a.max_distance,
                   "Distance, in units of the scene, up to which a surface occludes another for ao "
                   "(default: any)")
        ->check(CLI::PositiveNumber)
        ->group(group);
    app.add_option("-t,--threads", a.threads, "Default: all there are")
        ->check(CLI::Range(1, 4096))
        ->group(group);
}

}  // namespace

void declare_render_options(CLI::App& app, RenderArguments& a) {
    declare_scene(app, a.scene);
    declare_picture(app, a);
    declare_samples(app, a);
    declare_rendering(app, a);
    app.add_option("--stats", a.stats,
                   "Write counts, times, sizes and errors as JSON; - is standard output");
    app.add_flag("-q,--quiet", a.quiet, "No progress and no summary");
}

}  // namespace etalon
