#pragma once

#include <string>
#include <vector>

#include "app/common/integrators.h"
#include "app/common/options.h"
#include "app/scene_arguments.h"
#include "core/scene/render_settings.h"

namespace etalon {

/// Default number of seconds between two checkpoints.
inline constexpr int usual_checkpoint_interval = 60;

/// The command line of `etalon render`.
struct RenderArguments {
    SceneArguments scene;
    std::vector<std::string> outputs, aovs;
    std::string output_format, backend, integrator{scene_integrator},
        sampler = "sobol", mpi_scene = "each", resolution, crop, filter, stats, reference,
        checkpoint, part, tev;
    int samples = -1, max_depth = 0, threads = 0;
    std::size_t seed = 0;
    double exposure = 0, target_error = 0, time_limit = 0, max_distance = 0,
           checkpoint_every = 0;  ///< seconds; 0: as usual
    bool resume = false, spd = false, quiet = false, display_values = false;
    bool serve = false;  ///< `etalon serve`: a web page shows the image as it converges
    bool stay = false;   ///< the page stays when rendering is done
};

void declare_render_options(Options& options, RenderArguments& a);

/// Returns the name whose extension gives the format of an output: its own, or for "-", standard
/// output, one with the extension of --output-format.
std::string format_name(const RenderArguments& a, const std::string& output);

/// Overrides the scene's own settings by those of the command line. Returns why that is impossible,
/// or an empty string.
std::string apply_overrides(const RenderArguments& a, const Scene& scene, RenderSettings& settings);

}  // namespace etalon
