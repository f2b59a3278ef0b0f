#include <fmt/format.h>

#include "bench/accuracy/report/cases.h"
#include "bench/report/formatting.h"
#include "bench/report/sections/sections.h"

namespace etalon::bench_report {
namespace {

using namespace speed;

void add_speed(const std::vector<SceneFigures>& scenes, std::vector<KeyFigure>& key_figures) {
    std::vector<double> fast, robust;
    for (const SceneFigures& scene : scenes) {
        for (const KindFigures& kind : scene.kinds) {
            for (const RayFigures& r : kind.tracers) {
                if (r.tracer != default_backend) continue;
                fast.push_back(r.by_threads.front().ratio.median);
                robust.push_back(r.by_threads.front().ratio_robust.median);
            }
        }
    }
    if (fast.empty()) return;
    key_figures.push_back(
        {"×" + three_digits(geometric_mean(fast)), "ray speed",
         fmt::format("{} to {}, mean of {}; ×{} to its robust form", default_backend,
                     baseline_backend, count_of(scenes.size(), "scene"),
                     three_digits(geometric_mean(robust)))});
}

void add_builds(const std::vector<SceneFigures>& scenes, std::vector<KeyFigure>& key_figures) {
    std::vector<double> ratios, sizes;
    for (const SceneFigures& scene : scenes) {
        for (const BuildFigures& b : scene.builds) {
            if (b.tracer != default_backend) continue;
            ratios.push_back(b.by_threads.front().ratio.median);
            sizes.push_back(b.bytes_per_primitive);
        }
    }
    if (ratios.empty()) return;
    key_figures.push_back({"×" + three_digits(geometric_mean(ratios)), "build speed",
                           fmt::format("{} to {}; {} bytes a primitive", default_backend,
                                       baseline_backend, three_digits(geometric_mean(sizes)))});
}

void add_errors(const std::vector<accuracy::Row>& rows, std::vector<KeyFigure>& key_figures) {
    std::uint64_t exact_rays = 0, exact_errors = 0, baseline_rays = 0, baseline_errors = 0;
    for (const accuracy::Row& row : rows) {
        if (row.exact) exact_rays += row.stats.rays, exact_errors += row.stats.errors();
        if (row.tracer != accuracy::baseline) continue;
        baseline_rays += row.stats.rays;
        baseline_errors += row.stats.errors();
    }
    if (exact_rays == 0) return;
    key_figures.push_back({grouped(exact_errors), "wrong answers",
                           fmt::format("exact backends, {} hard rays", grouped(exact_rays))});
    if (baseline_rays == 0) return;
    const double share =
        100 * static_cast<double>(baseline_errors) / static_cast<double>(baseline_rays);
    key_figures.push_back(
        {fmt::format("{} %", three_digits(share)), "wrong answers",
         fmt::format("{}, {} of the same rays", baseline_backend, grouped(baseline_rays))});
}

}  // namespace

std::vector<KeyFigure> summary(const Results& results) {
    std::vector<KeyFigure> key_figures;
    add_speed(results.scenes.list, key_figures);
    add_errors(results.rows.list, key_figures);
    add_builds(results.scenes.list, key_figures);
    return key_figures;
}

}  // namespace etalon::bench_report
