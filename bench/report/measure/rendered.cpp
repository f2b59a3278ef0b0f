#include "bench/report/measure/rendered.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/backends.h"
#include "core/formats/load.h"

namespace etalon::bench_report {
namespace {

namespace fs = std::filesystem;

fs::path scenes_folder() {
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none).parent_path();
    for (const fs::path& root : {fs::path("."), program.parent_path().parent_path()}) {
        if (fs::exists(root / "scenes" / "showcase.p3f", none)) return root / "scenes";
    }
    return "scenes";
}

}  // namespace

std::optional<Scene> shipped_scene(const std::string& name, int width, int height) {
    LoadResult loaded = load_scene((scenes_folder() / name).string());
    fmt::print(stderr, "{}", report(loaded.diagnostics));
    if (!loaded.scene) return std::nullopt;
    loaded.scene->camera.width = width;
    loaded.scene->camera.height = height;
    return std::move(loaded.scene);
}

RenderOptions options_for(const Scene& scene, const Context& context) {
    RenderOptions options;
    options.samples_per_pixel = scene.samples_per_pixel;
    options.max_depth = scene.whitted.max_depth;
    options.window = {{0, 0}, {scene.camera.width - 1, scene.camera.height - 1}};
    options.stop = &context.stop;
    options.deadline = context.deadline;
    options.progress = context.progress;
    return options;
}

Rendered rendered(const Scene& scene, const std::string& backend, const RenderOptions& options) {
    std::vector<std::string> problems;  // what cannot be read is the background's colour
    const EnvironmentMap environment(scene.look.environment, problems);
    Stopwatch watch;
    const auto intersector = find_backend(backend)->build(scene.geometry);
    const Duration build = watch.lap();
    Rendering rendering = render(scene, *intersector, environment, options);
    return {std::move(rendering), build, watch.lap(), intersector->memory_bytes()};
}

}  // namespace etalon::bench_report
