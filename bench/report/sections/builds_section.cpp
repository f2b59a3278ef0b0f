// Section on builds: time and memory.
#include <fmt/format.h>

#include "bench/report/command_lines.h"
#include "bench/report/formatting.h"
#include "bench/report/sections/sections.h"

namespace etalon::bench_report {
namespace {

using namespace speed;

/// Wall time with the largest number of threads, given in the group's heading; empty if that is
/// one.
Cell with_most_threads(const BuildFigures& b, BarGroup& group) {
    const Runs& most = b.by_threads.back();
    if (most.threads == 1) return {};
    group.note = fmt::format("on {} threads", most.threads);
    return {three_digits(1e3 * median(most.wall())) + " ms"};
}

BarGroup times_of(const SceneFigures& scene) {
    BarGroup group{"time to build", "CPU ms", "× builtin", "", {}};
    for (const BuildFigures& b : scene.builds) {
        const Runs& runs = b.by_threads.front();
        const Estimate seconds = estimate(runs.cpu());
        group.bars.push_back({b.tracer, colour_of(b.tracer), 1e3 * seconds.median,
                              1e3 * seconds.spread.value_or(0), three_digits(1e3 * seconds.median),
                              times(runs.ratio), with_most_threads(b, group)});
    }
    return group;
}

BarGroup memory_of(const SceneFigures& scene) {
    BarGroup group{"memory", "B/prim", "in all", "", {}};
    for (const BuildFigures& b : scene.builds) {
        const double all = b.bytes_per_primitive * static_cast<double>(scene.primitives);
        group.bars.push_back({b.tracer,
                              colour_of(b.tracer),
                              b.bytes_per_primitive,
                              0,
                              three_digits(b.bytes_per_primitive),
                              bytes(all),
                              {}});
    }
    return group;
}

bool has_threads(const SceneFigures& scene) {
    return !scene.builds.empty() && scene.builds.front().by_threads.size() > 1;
}

}  // namespace

Section builds_section(const Results& results) {
    Section section{"builds", "Build time and memory", {}, {}};
    section.prose = {
        "What each backend needs before the first ray: CPU time on one pinned thread, "
        "and how many times as fast as embree-builtin’s own build that is; and the memory "
        "that its structure keeps, the scene itself not counted."};
    for (const SceneFigures& scene : results.scenes.list) {
        section.figures.push_back(
            {fmt::format("{}, {}", scene.scene, count_of(scene.primitives, "primitive")),
             fmt::format(
                 "CPU time to build on one thread, times as fast as embree-builtin{}; bytes "
                 "a primitive.",
                 has_threads(scene) ? "; the time on several threads" : ""),
             builds_command(results.settings, scene.scene), results.scenes.date,
             Bars{{times_of(scene), memory_of(scene)}}});
    }
    return section;
}

}  // namespace etalon::bench_report
