#include "bench/speed/measured_scene.h"

#include <algorithm>
#include <array>

#include "bench/speed/measured_rays.h"

namespace etalon::speed {
namespace {

std::vector<TimedTracer> enter(const SpeedConfig& config) {
    std::vector<TimedTracer> tracers;
    for (const std::string& name : config.tracers) {
        tracers.push_back({&find_tracer(name), nullptr});
    }
    return tracers;
}

std::string shape_of(const Geometry& geometry) {
    std::array<std::size_t, shape_kinds> counts{};
    for (const Primitive p : geometry.primitives) ++counts[p.kind];
    const auto most = std::ranges::max_element(counts);
    const bool is_nearly_all = *most > 0 && 10 * *most >= 9 * geometry.primitives.size();
    return is_nearly_all ? std::string(kind_name(static_cast<ShapeKind>(most - counts.begin())))
                         : "mixed";
}

}  // namespace

SceneFigures measure_scene(const std::string& name, Scene scene, const Imath::V2i& resolution,
                           const SpeedConfig& config, const Observer& observer) {
    hard::CaseSetup setup;
    setup.scene = std::move(scene);
    setup.size = half_size(setup.scene.geometry);
    const Geometry& geometry = setup.scene.geometry;
    SceneFigures figures{name, geometry.item_count(), shape_of(geometry), {}, {}};
    std::vector<TimedTracer> tracers = enter(config);
    figures.builds = measure_builds(tracers, setup.scene, config, observer.is_over);
    if (figures.builds.empty()) return figures;
    observer.show(figures);
    if (config.kinds.empty() || observer.is_over()) return figures;
    const RayMeasurement measurement(setup, tracers, config);
    for (const char* kind : ray_kinds) {
        if (std::find(config.kinds.begin(), config.kinds.end(), kind) == config.kinds.end())
            continue;
        if (observer.is_over()) break;
        const RaySet set =
            make_ray_set(kind, setup.scene, resolution, measurement.exact(), config.max_rays);
        if (set.rays.empty()) continue;
        std::optional<KindFigures> measured = measurement.measure(set, observer.is_over);
        if (!measured) break;
        figures.kinds.push_back(std::move(*measured));
        observer.show(figures);
    }
    return figures;
}

}  // namespace etalon::speed
