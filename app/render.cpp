#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "app/backends.h"
#include "app/commands.h"
#include "app/exit_status.h"
#include "app/output.h"
#include "app/progress.h"
#include "app/scene_arguments.h"
#include "app/signals.h"
#include "app/stats.h"
#include "core/image/io.h"
#include "core/parallel/parallel.h"
#include "core/render/camera_rays.h"
#include "core/render/renderer.h"
#include "core/render/spd_rules.h"

namespace etalon {
namespace {

constexpr int max_picture_side = 65536;

struct Arguments {
    SceneArguments scene;
    std::vector<std::string> outputs;
    std::string backend, integrator = "auto", resolution, crop, stats;
    int samples = -1, max_depth = 0, threads = 0;
    std::uint32_t seed = 0;
    double exposure = 0;
    bool spd = false, quiet = false;
};

void declare_options(CLI::App& app, Arguments& a) {
    declare_scene(app, a.scene);
    const char* what = "Picture";
    app.add_option("-o,--output", a.outputs,
                   "FILE.exr or FILE.png; may be repeated "
                   "(default: the scene's name with .exr, in this folder)")
        ->check([](const std::string& path) {
            return can_write(path) ? "" : path + ": expected a name ending in .exr or .png";
        })
        ->take_all()
        ->expected(1)
        ->group(what);
    app.add_option("--resolution", a.resolution, "WIDTHxHEIGHT instead of the scene's")
        ->group(what);
    app.add_option("--crop", a.crop, "X0,Y0,X1,Y1: only these pixels, half open")->group(what);
    app.add_option("--exposure", a.exposure, "Stops, for PNG only")->group(what);
    const char* how = "Rendering";
    app.add_option("-b,--backend", a.backend, "How hits are found (default: the scene's, else bvh)")
        ->check(CLI::IsMember(backend_names()))
        ->group(how);
    app.add_option("--integrator", a.integrator, "auto: what the scene's format asks for")
        ->check(CLI::IsMember({"auto", "whitted"}))
        ->group(how);
    app.add_option("--spp", a.samples, "Samples per pixel; 0: one ray through each pixel's centre")
        ->check(CLI::Range(0, 1 << 24))
        ->group(how);
    app.add_flag("--spd", a.spd,
                 "Count rays by the rules of the Standard Procedural Databases: one through each "
                 "pixel corner, a mirrored one from all glass")
        ->excludes("--spp")
        ->group(how);
    app.add_option("--max-depth", a.max_depth, "Rays in a row, the eye's ray included")
        ->check(CLI::Range(1, 1000))
        ->group(how);
    app.add_option("--seed", a.seed, "Of the sample points")->group(how);
    app.add_option("-t,--threads", a.threads, "Default: all there are")
        ->check(CLI::Range(1, 4096))
        ->group(how);
    app.add_option("--stats", a.stats,
                   "Write counts, times and sizes as JSON; - is standard output");
    app.add_flag("-q,--quiet", a.quiet, "No progress and no summary");
}

bool usage_error(const std::string& message) {
    fmt::print(stderr, "etalon: error: {}\n", message);
    return false;
}

bool apply_resolution(const std::string& text, Camera& camera) {
    if (text.empty()) return true;
    int width = 0, height = 0;
    char rest = 0;
    const bool parsed = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2;
    if (!parsed || width < 1 || height < 1 || std::max(width, height) > max_picture_side) {
        return usage_error("--resolution " + text + ": expected WIDTHxHEIGHT, e.g. 640x480");
    }
    camera.width = width;
    camera.height = height;
    return true;
}

bool apply_crop(const std::string& text, const Camera& camera, Imath::Box2i& window) {
    window = {{0, 0}, {camera.width - 1, camera.height - 1}};
    if (text.empty()) return true;
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    char rest = 0;
    const bool parsed = std::sscanf(text.c_str(), "%d,%d,%d,%d%c", &x0, &y0, &x1, &y1, &rest) == 4;
    const bool inside =
        0 <= x0 && x0 < x1 && x1 <= camera.width && 0 <= y0 && y0 < y1 && y1 <= camera.height;
    if (!parsed || !inside) {
        return usage_error(fmt::format("--crop {}: expected X0,Y0,X1,Y1 inside 0,0,{},{}", text,
                                       camera.width, camera.height));
    }
    window = {{x0, y0}, {x1 - 1, y1 - 1}};
    return true;
}

/// The command line's wishes put into the scene; false if they cannot be had.
bool apply(const Arguments& a, Scene& scene, Imath::Box2i& window) {
    if (a.samples >= 0) scene.samples_per_pixel = a.samples;
    if (a.spd) apply_spd_rules(scene);
    if (a.max_depth > 0) scene.whitted.max_depth = a.max_depth;
    if (!a.backend.empty()) scene.backend = a.backend;
    if (scene.backend.empty()) scene.backend = "bvh";
    return apply_resolution(a.resolution, scene.camera) && apply_crop(a.crop, scene.camera, window);
}

std::string default_output(const std::string& scene) {
    const std::string stem = scene == "-" ? "render" : std::filesystem::path(scene).stem().string();
    return stem + ".exr";
}

Picture make_picture(const Scene& scene, const Rendering& rendering, const RenderStats& stats) {
    const CameraRays camera(scene.camera);
    Picture picture{scene.camera.width,      scene.camera.height,  rendering.film.window(),
                    rendering.film.pixels(), scene.display_colors, {}};
    picture.metadata = {{"software", std::string("Etalon " ETALON_VERSION)},
                        {"backend", stats.backend},
                        {"integrator", std::string("whitted")},
                        {"samplesPerPixel", static_cast<int>(std::lround(rendering.samples))},
                        {"seed", fmt::format("{}", stats.seed)},
                        {"renderTimeSeconds", static_cast<float>(stats.render.wall)},
                        {"worldToCamera", Imath::M44f(camera.world_to_camera())},
                        {"worldToNDC", Imath::M44f(camera.world_to_ndc())}};
    return picture;
}

/// One run of the subcommand, in the order things happen.
class Render {
  public:
    explicit Render(Arguments arguments) : a_(std::move(arguments)) {}

    int run() {
        const ThreadLimit limit(a_.threads);
        LoadedScene loaded = load(a_.scene);
        if (!loaded.scene) return loaded.status;
        scene_ = std::move(*loaded.scene);
        stats_.parse = watch_.lap();
        if (!apply(a_, scene_, window_)) return exit_usage;
        if (a_.outputs.empty()) a_.outputs = {default_output(a_.scene.path)};
        if (!outputs_are_writable()) return exit_not_written;
        if (!build()) return exit_unusable;
        const Rendering rendering = render_picture();
        const bool written = rendering.counts.camera == 0 || write(rendering);
        if (signals_.signal() != 0) return exit_signal + signals_.signal();
        return written ? exit_done : exit_not_written;
    }

  private:
    bool outputs_are_writable() const {
        for (const std::string& path : a_.outputs) {
            const std::string obstacle = obstacle_to_writing(path);
            if (!obstacle.empty()) return usage_error(obstacle);
        }
        return true;
    }

    bool build() {
        std::vector<std::string> problems;
        environment_.emplace(scene_.environment, problems);
        for (const std::string& problem : problems) {
            fmt::print(stderr, "{}: warning: {}; the background colour stands in\n", a_.scene.path,
                       problem);
        }
        if (a_.scene.options.strict && !problems.empty()) return false;
        intersector_ = find_backend(scene_.backend)->build(scene_);
        stats_.build = watch_.lap();
        return intersector_ != nullptr;
    }

    Rendering render_picture() {
        std::optional<Progress> progress;
        if (!a_.quiet) progress.emplace(a_.scene.path);
        RenderOptions options;
        options.samples_per_pixel = scene_.samples_per_pixel;
        options.max_depth = scene_.whitted.max_depth;
        options.seed = a_.seed;
        options.window = window_;
        options.stop = &signals_.raised();
        if (progress) options.progress = [&](double part) { progress->update(part); };
        Rendering rendering = render(scene_, *intersector_, *environment_, options);
        stats_.render = watch_.lap();
        return rendering;
    }

    bool write(const Rendering& rendering) {
        fill_stats(rendering);
        const Picture picture = make_picture(scene_, rendering, stats_);
        bool written = true;
        for (const std::string& path : a_.outputs) {
            const std::string error = write_picture(path, picture, a_.exposure);
            if (!error.empty()) written = usage_error(error);
        }
        stats_.write = watch_.lap();
        if (!a_.stats.empty()) {
            written = write_json(a_.stats, to_json(stats_)) && written;
        }
        if (!a_.quiet && written) summarise(rendering);
        return written;
    }

    void fill_stats(const Rendering& rendering) {
        stats_.scene = a_.scene.path;
        stats_.format = scene_.format;
        stats_.backend = scene_.backend;
        stats_.isa = intersector_->isa();
        stats_.threads = max_threads();
        stats_.width = scene_.camera.width;
        stats_.height = scene_.camera.height;
        stats_.samples_per_pixel = scene_.samples_per_pixel;
        stats_.seed = a_.seed;
        stats_.primitives = primitive_counts(scene_);
        stats_.rays = rendering.counts;
        stats_.scene_bytes = memory_bytes(scene_);
        stats_.accelerator_bytes = intersector_->memory_bytes();
    }

    void summarise(const Rendering& rendering) const {
        fmt::print(stderr, "{}{}: {} primitives, {}, {:.2f} Mrays in {:.2f} s -> {}\n",
                   a_.scene.path, rendering.complete ? "" : " (stopped early)",
                   scene_.primitives.size(), scene_.backend,
                   1e-6 * static_cast<double>(rendering.counts.total()), stats_.render.wall,
                   fmt::join(a_.outputs, ", "));
    }

    Arguments a_;
    SignalGuard signals_;
    Stopwatch watch_;
    Scene scene_;
    Imath::Box2i window_;
    RenderStats stats_;
    std::optional<EnvironmentMap> environment_;
    std::unique_ptr<Intersector> intersector_;
};

}  // namespace

Run declare_render(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    declare_options(app, *arguments);
    return [arguments] { return Render(*arguments).run(); };
}

}  // namespace etalon
