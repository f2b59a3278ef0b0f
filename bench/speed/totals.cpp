#include "bench/speed/totals.h"

#include <algorithm>

namespace etalon::speed {
namespace {

Totals& totals_of(const std::string& tracer, std::vector<Totals>& all) {
    const auto found = std::ranges::find(all, tracer, &Totals::tracer);
    if (found != all.end()) return *found;
    all.push_back({tracer, {}, {}, {}, {}});
    return all.back();
}

}  // namespace

std::vector<Totals> totals_of(std::span<const SceneFigures> scenes) {
    std::vector<Totals> all;
    for (const SceneFigures& scene : scenes) {
        for (const KindFigures& kind : scene.kinds) {
            for (const RayFigures& r : kind.tracers) {
                Totals& totals = totals_of(r.tracer, all);
                totals.ratios.push_back(r.by_threads.front().ratio.median);
                totals.robust_ratios.push_back(r.by_threads.front().ratio_robust.median);
                totals.sampled.add(r.errors.sample);
                totals.disputed.add(r.errors.disputed);
            }
        }
    }
    return all;
}

}  // namespace etalon::speed
