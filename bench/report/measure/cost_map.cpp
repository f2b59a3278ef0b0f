#include "bench/report/measure/cost_map.h"

#include "app/common/backends.h"
#include "bench/report/measure/rendered.h"
#include "core/integrators/integrators.h"
#include "core/render/features.h"

namespace etalon::bench_report {

/// Renders each pixel as a separate image, since rays are counted per image.
std::optional<PixelPlane> rays_of_samples(const Scene& scene, const RenderSettings& settings,
                                          const TaskProgress& task_progress) {
    const auto intersector = find_backend(default_backend)->build(scene.geometry);
    std::vector<std::string> problems;
    const auto integrator =
        find_integrator(settings.integrator)->make(scene, *intersector, settings, problems);
    RunControl control = control_of(task_progress);
    control.observers.clear();
    const int width = settings.resolution.x, height = settings.resolution.y;
    PixelPlane rays = plane_of(width, height, [&](std::size_t pixel) {
        const Imath::V2i at(static_cast<int>(pixel) % width, static_cast<int>(pixel) / width);
        RenderSettings here = settings;
        here.crop = {at, at};
        const RayCounts counts = render(scene.camera, *integrator, here, control).counts;
        return static_cast<double>(counts.total()) / settings.samples_per_pixel;
    });
    return task_progress.is_over() ? std::nullopt : std::optional(std::move(rays));
}

std::optional<PixelPlane> tests_of_camera_rays(const Scene& scene, const RenderSettings& settings,
                                               const std::string& backend,
                                               const TaskProgress& task_progress) {
    const auto intersector = find_backend(backend)->build(scene.geometry);
    const std::optional<CentreHits> hits =
        centre_hits(scene, *intersector, settings, &task_progress.stop);
    if (!hits || hits->costs.empty()) return std::nullopt;
    return plane_of(settings.resolution.x, settings.resolution.y, [&](std::size_t pixel) {
        const TraversalCost& cost = hits->costs[pixel];
        return static_cast<double>(cost.box_tests + cost.primitive_tests);
    });
}

}  // namespace etalon::bench_report
