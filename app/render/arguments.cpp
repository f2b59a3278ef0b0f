#include "app/render/arguments.h"

#include <fmt/core.h>

#include "app/common/backends.h"
#include "app/common/integrators.h"
#include "app/render/aovs.h"
#include "core/image/io.h"

namespace etalon {
namespace {

void declare_image(Options& options, RenderArguments& a) {
    const char* group = "Picture";
    options
        .add("-o,--output", a.outputs,
             "FILE.exr or FILE.png; may be repeated "
             "(default: the scene's name with .exr, in this folder)")
        .check([](const std::string& path) {
            return can_write(path) ? "" : path + ": expected a name ending in .exr or .png";
        })
        .one_value_each()
        .group(group);
    options.add("--resolution", a.resolution, "WIDTHxHEIGHT instead of the scene's").group(group);
    options.add("--crop", a.crop, "X0,Y0,X1,Y1: only these pixels, half open").group(group);
    options.add("--aov", a.aovs, "NAME,...: channels of the EXR beside the colours: " + aov_names())
        .by_commas()
        .check(check_aov)
        .group(group);
    options.add("--exposure", a.exposure, "Stops, for PNG only").group(group);
}

void declare_samples(Options& options, RenderArguments& a) {
    const char* group = "Samples";
    options
        .add("--spp", a.samples,
             "Samples per pixel, at most; 0: one ray through each pixel's centre "
             "(default: the scene's, but 65536 with --target-error or --time-limit)")
        .within(0, 1 << 24)
        .group(group);
    options
        .add("--target-error", a.target_error,
             "relMSE, as `etalon compare` has it, at which the picture is good enough; samples "
             "go where they help most")
        .positive()
        .group(group);
    options.add("--time-limit", a.time_limit, "Seconds of rendering after which it ends")
        .positive()
        .group(group);
    options
        .add("--reference", a.reference,
             "A picture of the same size: say how far from it this one is, and at what time")
        .group(group);
    options.add("--sampler", a.sampler, "Sample generator")
        .one_of({"sobol", "random"})
        .group(group);
    options.add("--seed", a.seed, "Random seed").group(group);
    options
        .add_flag("--spd", a.spd,
                  "Count rays by the rules of the Standard Procedural Databases: one through each "
                  "pixel corner, a mirrored one from all glass")
        .excludes("--spp")
        .excludes("--target-error")
        .group(group);
}

/// "Integrator (default: auto, the scene's own); whitted: ..., ao: ...".
std::string integrator_help() {
    std::string text = "How the colour of a sample is computed (default: auto, the scene's own)";
    for (const IntegratorType& type : all_integrators()) {
        text += fmt::format("; {}: {}", type.name, type.summary);
    }
    return text;
}

void declare_rendering(Options& options, RenderArguments& a) {
    const char* group = "Rendering";
    options.add("-b,--backend", a.backend, "How hits are found (default: the scene's, else bvh)")
        .one_of(backend_names())
        .group(group);
    options.add("--integrator", a.integrator, integrator_help())
        .one_of(integrator_choices())
        .group(group);
    options
        .add("--max-depth", a.max_depth,
             "Maximum path length of whitted, including the camera ray (default: the scene's)")
        .within(1, 1000)
        .group(group);
    options
        .add("--max-distance", a.max_distance,
             "Distance, in units of the scene, up to which a surface occludes another for ao "
             "(default: any)")
        .positive()
        .group(group);
    options.add("-t,--threads", a.threads, "Default: all there are").within(1, 4096).group(group);
}

}  // namespace

void declare_render_options(Options& options, RenderArguments& a) {
    declare_scene(options, a.scene);
    declare_image(options, a);
    declare_samples(options, a);
    declare_rendering(options, a);
    options.add("--stats", a.stats,
                "Write counts, times, sizes and errors as JSON; - is standard output");
    options.add_flag("-q,--quiet", a.quiet, "No progress and no summary");
}

}  // namespace etalon
