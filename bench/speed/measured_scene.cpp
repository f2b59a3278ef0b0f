#include "bench/speed/measured_scene.h"

#include <algorithm>

#include "bench/speed/measured_rays.h"

namespace etalon::speed {
namespace {

std::vector<Tracer> enter(const Plan& plan) {
    std::vector<Tracer> tracers;
    for (const std::string& name : plan.tracers) {
        tracers.push_back({&find_tracer(name), nullptr});
    }
    return tracers;
}

}  // namespace

SceneFigures measure_scene(const std::string& name, Scene scene, const Imath::V2i& resolution,
                           const Plan& plan, const Observer& observer) {
    hard::CaseSetup setup;
    setup.scene = std::move(scene);
    SceneFigures figures{name, setup.scene.geometry.primitives.size(), {}, {}};
    std::vector<Tracer> tracers = enter(plan);
    figures.builds = measure_builds(tracers, setup.scene, plan, observer.is_over);
    if (figures.builds.empty()) return figures;
    observer.show(figures);
    if (plan.kinds.empty()) return figures;
    const RayMeasurement measurement(setup, tracers, plan);
    for (const char* kind : ray_kinds) {
        if (std::find(plan.kinds.begin(), plan.kinds.end(), kind) == plan.kinds.end()) continue;
        const RaySet set =
            make_ray_set(kind, setup.scene, resolution, measurement.exact(), plan.max_rays);
        if (set.rays.empty()) continue;
        std::optional<KindFigures> measured = measurement.measure(set, observer.is_over);
        if (!measured) break;
        figures.kinds.push_back(std::move(*measured));
        observer.show(figures);
    }
    return figures;
}

}  // namespace etalon::speed
