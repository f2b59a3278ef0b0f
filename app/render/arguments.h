#pragma once

#include <string>
#include <vector>

#include "app/options.h"
#include "app/scene_arguments.h"
#include "core/render/renderer.h"

namespace etalon {

/// The command line of `etalon render`.
struct RenderArguments {
    SceneArguments scene;
    std::vector<std::string> outputs, aovs;
    std::string backend, integrator = "auto", sampler = "sobol", resolution, crop, stats, reference;
    int samples = -1, max_depth = 0, threads = 0;
    std::uint32_t seed = 0;
    double exposure = 0, target_error = 0, time_limit = 0;
    bool spd = false, quiet = false;
};

void declare_render_options(Options& options, RenderArguments& a);

/// The command line's wishes put into the scene, and the pixels it asks for; returns the reason why
/// they cannot be had, or nothing.
std::string apply(const RenderArguments& a, Scene& scene, Imath::Box2i& window);

/// How these pixels of such a scene are to be rendered, from now on.
RenderOptions render_options(const RenderArguments& a, const Scene& scene,
                             const Imath::Box2i& window);

}  // namespace etalon
