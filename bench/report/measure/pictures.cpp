#include <fmt/format.h>

#include <numeric>

#include "app/backends.h"
#include "bench/report/commands.h"
#include "bench/report/measure/rendered.h"
#include "bench/report/words.h"
#include "core/image/encode.h"
#include "core/image/metrics/flip.h"
#include "core/image/metrics/magma.h"
#include "core/image/oiio.h"
#include "core/render/features.h"

namespace etalon::bench_report {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::string samples_of(int count) {
    return count_of(static_cast<std::uint64_t>(count), "sample") + " a pixel";
}

Rendered rendered(const Scene& scene, int samples, std::uint32_t seed, const Context& context) {
    RenderOptions options = options_for(scene, context);
    options.samples_per_pixel = samples;
    options.seed = seed;
    return bench_report::rendered(scene, "bvh", options);
}

Bytes display(const Scene& scene, const std::vector<Color>& pixels) {
    const Camera& camera = scene.camera;
    const Imath::Box2i window{{0, 0}, {camera.width - 1, camera.height - 1}};
    return display_bytes({camera.width, camera.height, window, pixels, scene.display_colors, {}},
                         0);
}

/// Without the layer if there is no PNG.
void add(const std::string& title, const Bytes& rgb, PictureFigures& figures) {
    Outcome<std::string> png = encode_png(rgb, figures.width, figures.height);
    if (png) return figures.layers.push_back({title, std::move(png.value)});
    fmt::print(stderr, "etalon-bench: warning: {}\n", png.error);
}

/// Boxes and primitives tested by an eye ray of each pixel; nothing if the backend does not count.
std::optional<PixelPlane> tests_of_eye_rays(const Scene& scene, const std::string& backend,
                                            const Context& context) {
    const auto intersector = find_backend(backend)->build(scene);
    RenderOptions options = options_for(scene, context);
    options.progress = nullptr;
    const std::optional<CentreHits> hits = centre_hits(scene, *intersector, options);
    if (!hits || hits->costs.empty()) return std::nullopt;
    return plane_of(scene.camera.width, scene.camera.height, [&](std::size_t pixel) {
        const TraversalCost& cost = hits->costs[pixel];
        return static_cast<double>(cost.box_tests + cost.primitive_tests);
    });
}

/// On one scale. Pale is what one pixel of a hundred exceeds by any backend: the few worst ones
/// would make all others dark.
void add_costs(const Scene& scene, const Context& context, PictureFigures& figures) {
    std::vector<std::pair<std::string, PixelPlane>> maps;
    double white = 1;
    for (const std::string backend : {"bvh", "grid"}) {
        std::optional<PixelPlane> map = tests_of_eye_rays(scene, backend, context);
        if (!map) continue;
        white = std::max(white, speed::quantile(map->values, 0.99));
        maps.emplace_back(backend, std::move(*map));
    }
    for (const auto& [backend, map] : maps) {
        const double mean = std::reduce(map.values.begin(), map.values.end()) /
                            static_cast<double>(map.values.size());
        add(fmt::format("Tests of an eye ray by {}, mean {}, pale {}", backend, three_digits(mean),
                        three_digits(white)),
            magma(map, white), figures);
    }
}

void measure(const PictureRequest& request, Results& results, const Context& context) {
    const std::optional<Scene> scene = shipped_scene(request.scene, request.width, request.height);
    if (!scene) return;
    const Rendered many = rendered(*scene, request.samples, 0, context.part(0, 0.9));
    const Rendered few = rendered(*scene, request.fewer_samples, 1, context.part(0.9, 1));
    if (!many.rendering.complete || !few.rendering.complete) return;
    PictureFigures figures{request.scene,
                           picture_command(request),
                           request.width,
                           request.height,
                           scene->primitives.size(),
                           many.render,
                           {}};
    const std::vector<Color> picture = many.rendering.film.pixels();
    const PixelPlane error = flip_map(few.rendering.film.pixels(), picture, request.width);
    add(samples_of(request.samples), display(*scene, picture), figures);
    add(fmt::format("FLIP of {}, mean {}", samples_of(request.fewer_samples),
                    three_digits(flip(error))),
        magma(error), figures);
    add_costs(*scene, context, figures);
    results.pictures.add(std::move(figures));
}

}  // namespace

std::vector<Task> picture_tasks(const Settings& settings) {
    std::vector<Task> tasks;
    for (const PictureRequest& request : settings.pictures) {
        const double samples =
            1.0 * request.width * request.height * (request.samples + request.fewer_samples);
        tasks.push_back({request.scene, 0.1 + 0.5e-6 * request.microseconds * samples,
                         [request](Results& results, const Context& context) {
                             measure(request, results, context);
                         }});
    }
    return tasks;
}

}  // namespace etalon::bench_report
