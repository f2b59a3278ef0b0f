#include "bench/report/measure/rendered.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/common/backends.h"
#include "app/common/console.h"
#include "core/formats/load.h"
#include "core/integrators/integrators.h"
#include "core/scene/resize.h"
#include "core/shading/textured_cut_outs.h"

namespace etalon::bench_report {
namespace {

namespace fs = std::filesystem;

/// Looks below the working directory, next to the build folder, and where Etalon is installed.
fs::path scenes_folder() {
    std::error_code none;
    const fs::path prefix = fs::read_symlink("/proc/self/exe", none).parent_path().parent_path();
    for (const fs::path& root :
         {fs::path("."), prefix.parent_path(), prefix / "share" / "etalon"}) {
        if (fs::exists(root / "scenes" / "showcase.p3f", none)) return root / "scenes";
    }
    return "scenes";
}

}  // namespace

std::string shipped_path(const std::string& name) {
    return (scenes_folder() / name).lexically_normal().string();
}

std::optional<ShippedScene> shipped_scene(const std::string& name) {
    LoadResult loaded = load_scene(shipped_path(name));
    write_message(report(loaded.diagnostics));
    if (!loaded.scene) return std::nullopt;
    std::vector<std::string> problems;  // the integrator reports them
    make_cut_outs(*loaded.scene, problems);
    return ShippedScene{std::move(*loaded.scene), std::move(loaded.settings)};
}

std::optional<ShippedScene> shipped_scene(const std::string& name, int width, int height) {
    std::optional<ShippedScene> shipped = shipped_scene(name);
    if (shipped) resize(shipped->settings, {width, height});
    return shipped;
}

RunControl control_of(const TaskProgress& task_progress) {
    return {.stop = &task_progress.stop,
            .stop_at = task_progress.deadline,
            .observers = {{.progress = task_progress.progress}}};
}

Rendered rendered(const Scene& scene, const std::string& backend, const RenderSettings& settings,
                  const RunControl& control) {
    Stopwatch watch;
    const auto intersector = find_backend(backend)->build(scene.geometry);
    const Duration build = watch.lap();
    std::vector<std::string> problems;  // unreadable images have the background colour
    const auto integrator =
        find_integrator(settings.integrator)->make(scene, *intersector, settings, problems);
    watch.lap();
    Rendering rendering = render(scene.camera, *integrator, settings, control);
    return {std::move(rendering), build, watch.lap(), intersector->memory_bytes()};
}

}  // namespace etalon::bench_report
