#include <fmt/format.h>

#include "app/common/backends.h"
#include "app/common/console.h"
#include "app/common/exit_status.h"
#include "app/common/fail.h"
#include "app/common/hit_text.h"
#include "app/common/output.h"
#include "app/common/progress.h"
#include "app/common/signals.h"
#include "app/replaced_images.h"
#include "app/scene_arguments.h"
#include "app/subcommands.h"
#include "app/trace/ray_file.h"
#include "core/intersect/kernels.h"

namespace etalon {
namespace {

struct TraceArguments {
    SceneArguments scene;
    std::string rays, output = "-", backend;
    bool shadow = false;
};

std::string describe(const Scene& scene, const Ray& ray, const std::optional<Hit>& hit) {
    if (!hit) return "miss\n";
    const Vec3 n = surface_at(scene.geometry, ray, *hit).normal;
    return fmt::format("{} {:.17g} {:.17g} {:.17g}\n", hit_text(scene.geometry, *hit), n.x, n.y,
                       n.z);
}

/// Returns a line for each ray, until a stop. `name` is that of the rays.
std::string hits_of(const std::vector<Ray>& rays, const Scene& scene,
                    const Intersector& intersector, const std::string& name,
                    const std::atomic<bool>& stop) {
    constexpr std::size_t often = 1024;
    Progress progress(name);
    std::string text;
    for (std::size_t i = 0; i < rays.size() && !stop; ++i) {
        text += describe(scene, rays[i], intersector.closest(rays[i]));
        if (i % often == 0) {
            progress.update(static_cast<double>(i) / static_cast<double>(rays.size()));
        }
    }
    return text;
}

/// Reports problems with the files of the arguments; returns the exit status.
int check_files(const TraceArguments& a) {
    auto [error, status] = check_outputs({a.output}, {a.scene.path, a.rays});
    if (a.rays == "-" && a.scene.path == "-") {
        error = "the scene and the rays cannot both be standard input";
        status = exit_usage;
    }
    return error.empty() ? exit_done : fail(status, error);
}

int trace(const TraceArguments& a) {
    if (const int status = check_files(a); status != exit_done) return status;
    LoadedScene loaded = load(a.scene);
    if (!loaded.scene) return loaded.status;
    if (refuse_outputs({a.output}, loaded.files)) return exit_usage;
    if (!make_cut_outs(*loaded.scene, a.scene)) return exit_unusable;
    const Scene& scene = *loaded.scene;
    auto rays = read_rays(a.rays);
    if (!rays) {
        print_message("{}\n", rays.error);
        return exit_unusable;
    }
    if (a.shadow) {
        for (Ray& ray : rays.value) ray.set_shadow();
    }
    if (!a.backend.empty()) loaded.settings.backend = a.backend;
    const auto intersector = chosen_backend(loaded.settings).build(scene.geometry);
    const SignalGuard signals;
    const std::string hits = hits_of(rays.value, scene, *intersector, a.rays, signals.raised());
    if (!write_text(a.output, hits)) return exit_not_written;
    return signals.signal() != 0 ? exit_signal + signals.signal() : exit_done;
}

}  // namespace

Action declare_trace(Options& options) {
    auto a = std::make_shared<TraceArguments>();
    declare_scene(options, a->scene);
    options
        .add("--rays", a->rays,
             fmt::format("File with one ray per line, '{}', decimal or hexadecimal; - is standard "
                         "input",
                         ray_format))
        .value("FILE")
        .required();
    options.add_flag("--shadow", a->shadow,
                     "All rays are shadow rays: they pass where a shadowalpha is 0, too");
    options
        .add("-o,--output", a->output,
             "File for the hits, one line per ray (default: standard output)")
        .value("FILE");
    options
        .add("-b,--backend", a->backend,
             "Backend that finds the hits (default: the scene's, else bvh)")
        .one_of(backend_names());
    return [a] { return trace(*a); };
}

}  // namespace etalon
