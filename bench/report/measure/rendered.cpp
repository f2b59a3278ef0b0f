#include "bench/report/measure/rendered.h"

#include "app/backends.h"

namespace etalon::bench_report {

Rendered rendered(const Scene& scene, const std::string& backend, const Context& context) {
    std::vector<std::string>
        problems;  // a picture that is missing was said when the scene was read
    const EnvironmentMap environment(scene.environment, problems);
    RenderOptions options;
    options.samples_per_pixel = scene.samples_per_pixel;
    options.max_depth = scene.whitted.max_depth;
    options.window = {{0, 0}, {scene.camera.width - 1, scene.camera.height - 1}};
    options.stop = &context.stop;
    options.progress = context.progress;
    Stopwatch watch;
    const auto intersector = find_backend(backend)->build(scene);
    const Duration build = watch.lap();
    Rendering rendering = render(scene, *intersector, environment, options);
    return {std::move(rendering), build, watch.lap(), intersector->memory_bytes()};
}

}  // namespace etalon::bench_report
