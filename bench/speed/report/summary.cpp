#include "bench/speed/report/columns.h"
#include "bench/speed/report/speed_table.h"

namespace etalon::speed {
namespace {

/// One tracer over all kinds of rays.
struct Sum {
    Sum(const SceneFigures& scene, std::size_t tracer) {
        for (const KindFigures& kind : scene.kinds) {
            const RayFigures& r = kind.tracers[tracer];
            ratios.push_back(r.by_threads.front().ratio.median);
            robust_ratios.push_back(r.by_threads.front().ratio_robust.median);
            judged += r.errors.sample.rays;
            wrong += r.errors.sample.errors();
            disputed += r.errors.disputed.rays;
            lost += r.errors.disputed.errors();
        }
    }

    std::vector<double> ratios, robust_ratios;
    std::uint64_t judged = 0, wrong = 0;   ///< of samples
    std::uint64_t disputed = 0, lost = 0;  ///< rays about which tracers differ; wrong there
};

}  // namespace

std::string summary(const SceneFigures& scene) {
    std::string text =
        scene.scene + ", to builtin (to robust; wrong of sampled, of disputed rays):";
    for (std::size_t i = 0; i < scene.builds.size() && !scene.kinds.empty(); ++i) {
        const Sum sum(scene, i);
        text += fmt::format(" {} {} ({}; {}/{}, {}/{}),", scene.builds[i].tracer,
                            figure(geometric_mean(sum.ratios)),
                            figure(geometric_mean(sum.robust_ratios)), sum.wrong, sum.judged,
                            sum.lost, sum.disputed);
    }
    text.back() = '\n';
    return text;
}

}  // namespace etalon::speed
