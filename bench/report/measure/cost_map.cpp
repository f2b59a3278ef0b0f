#include "bench/report/measure/cost_map.h"

#include "app/backends.h"
#include "bench/report/measure/rendered.h"
#include "core/render/features.h"

namespace etalon::bench_report {

/// Rays are counted by the picture: so each pixel is a picture of its own.
PixelPlane rays_of_samples(const Scene& scene, int samples_per_pixel, const Context& context) {
    std::vector<std::string> problems;
    const EnvironmentMap environment(scene.look.environment, problems);
    const auto intersector = find_backend("bvh")->build(scene.geometry);
    RenderOptions options = options_for(scene, context);
    options.samples_per_pixel = samples_per_pixel;
    options.progress = nullptr;
    const int width = scene.camera.width;
    return plane_of(width, scene.camera.height, [&](std::size_t pixel) {
        const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
        RenderOptions here = options;
        here.window = {{x, y}, {x, y}};
        const RayCounts counts = render(scene, *intersector, environment, here).counts;
        return static_cast<double>(counts.total()) / samples_per_pixel;
    });
}

std::optional<PixelPlane> tests_of_eye_rays(const Scene& scene, const std::string& backend,
                                            const Context& context) {
    const auto intersector = find_backend(backend)->build(scene.geometry);
    RenderOptions options = options_for(scene, context);
    options.progress = nullptr;
    const std::optional<CentreHits> hits = centre_hits(scene, *intersector, options);
    if (!hits || hits->costs.empty()) return std::nullopt;
    return plane_of(scene.camera.width, scene.camera.height, [&](std::size_t pixel) {
        const TraversalCost& cost = hits->costs[pixel];
        return static_cast<double>(cost.box_tests + cost.primitive_tests);
    });
}

}  // namespace etalon::bench_report
