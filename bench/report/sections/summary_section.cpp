#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "bench/accuracy/report/cases.h"
#include "bench/report/formatting.h"
#include "bench/report/sections/foreign_ratios.h"
#include "bench/report/sections/sections.h"
#include "bench/speed/totals.h"

namespace etalon::bench_report {
namespace {

using namespace speed;

/// Scenes by the shape of nearly all of their primitives.
std::map<std::string, std::vector<SceneFigures>> by_shape(const std::vector<SceneFigures>& scenes) {
    std::map<std::string, std::vector<SceneFigures>> groups;
    for (const SceneFigures& scene : scenes) groups[scene.shape].push_back(scene);
    return groups;
}

/// Adds a figure for each kind of scene: a mean of all would hide their differences.
void add_speed(const std::vector<SceneFigures>& all, std::vector<KeyFigure>& key_figures) {
    for (const auto& [shape, scenes] : by_shape(all)) {
        for (const Totals& totals : totals_of(scenes)) {
            if (totals.tracer != default_backend) continue;
            const auto [least, most] = std::ranges::minmax(totals.ratios);
            key_figures.push_back(
                {"×" + three_digits(geometric_mean(totals.ratios)), shape + " scenes, ray speed",
                 fmt::format("{} to {}: ×{} to ×{} over {} and the kinds of rays", default_backend,
                             baseline_backend, three_digits(least), three_digits(most),
                             count_of(scenes.size(), "scene"))});
        }
    }
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
    const auto [least, most] = std::ranges::minmax(ratios);
    key_figures.push_back(
        {"×" + three_digits(geometric_mean(ratios)), "build speed",
         fmt::format("{} to {}: ×{} to ×{} over {}; {} bytes a primitive", default_backend,
                     baseline_backend, three_digits(least), three_digits(most),
                     count_of(ratios.size(), "scene"), three_digits(geometric_mean(sizes)))});
}

/// Wrong answers of a group of tracers to decided rays. A ray is counted once, however many tracers
/// it is given to.
struct WrongAnswers {
    void add(const accuracy::CaseRows& c, const std::function<bool(const accuracy::Row&)>& counts) {
        std::uint64_t most_rays = 0, most_errors = 0;
        for (const accuracy::Row* row : c.rows) {
            if (!counts(*row)) continue;
            most_rays = std::max(most_rays, row->stats.decided());
            most_errors = std::max(most_errors, row->stats.errors());
        }
        rays += most_rays;
        errors += most_errors;
    }

    std::uint64_t rays = 0, errors = 0;
};

void add_errors(const std::vector<accuracy::Row>& rows, std::vector<KeyFigure>& key_figures) {
    WrongAnswers exact, baseline;
    for (const std::string& shape : accuracy::shapes_of(rows)) {
        for (const accuracy::CaseRows& c : accuracy::cases_of(rows, shape)) {
            exact.add(c, [](const accuracy::Row& row) { return row.exact; });
            baseline.add(c,
                         [](const accuracy::Row& row) { return row.tracer == accuracy::baseline; });
        }
    }
    if (exact.rays == 0) return;
    key_figures.push_back(
        {grouped(exact.errors), "wrong answers",
         fmt::format("exact backends; {} hard rays, each counted once", grouped(exact.rays))});
    if (baseline.rays == 0) return;
    const double share =
        100 * static_cast<double>(baseline.errors) / static_cast<double>(baseline.rays);
    key_figures.push_back({fmt::format("{} %", three_digits(share)), "wrong answers",
                           fmt::format("{}, {} of those rays: where Embree has the shape",
                                       baseline_backend, grouped(baseline.rays))});
}

void add_foreign(const std::vector<ForeignFigures>& foreign, std::vector<KeyFigure>& key_figures) {
    for (const ForeignRatios& r : foreign_ratios(foreign)) {
        key_figures.push_back({"×" + three_digits(geometric_mean(r.ratios)),
                               "less CPU time to equal error",
                               fmt::format("than {}, the mean of {}", r.program,
                                           count_of(r.ratios.size(), "scene"))});
    }
}

}  // namespace

std::vector<KeyFigure> summary(const Results& results) {
    std::vector<KeyFigure> key_figures;
    add_speed(results.scenes.list, key_figures);
    add_errors(results.rows.list, key_figures);
    add_builds(results.scenes.list, key_figures);
    add_foreign(results.foreign.list, key_figures);
    return key_figures;
}

}  // namespace etalon::bench_report
