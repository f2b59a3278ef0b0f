// Measurements that are stopped keep what is complete.
#include <atomic>

#include "bench/convergence/measure_curves.h"
#include "bench/scenes/bench_scene.h"
#include "bench/speed/measured_scene.h"
#include "bench/speed/timed_tracer.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

constexpr int tracers = 3;  // bvh and the two baselines

speed::SpeedConfig config() {
    speed::SpeedConfig c;
    c.tracers = speed::with_baselines({"bvh"});
    c.repeats = 4;
    c.oracle_seconds = 1e6;
    c.kinds = {"camera", "random"};
    c.max_rays = 200;
    return c;
}

/// Measures a scene until it was asked so often whether it is over.
speed::SceneFigures measured(int asked) {
    int times = 0;
    bench::NamedScene named = bench::bench_scene("spheres:50");
    return speed::measure_scene("spheres:50", std::move(*named.scene), {16, 16}, config(),
                                {[](const auto&) {}, [&] { return times++ >= asked; }});
}

}  // namespace

TEST_CASE("Builds: given a stop within a repeat, then those before it are kept") {
    const speed::SceneFigures figures = measured(2 * tracers + 1);
    REQUIRE(figures.builds.size() == tracers);
    for (const speed::BuildFigures& b : figures.builds) {
        CHECK(b.by_threads.front().repeats.size() == 2);
        CHECK(b.by_threads.front().ratio.median > 0);
        CHECK(b.bytes_per_primitive > 0);
    }
    CHECK(figures.kinds.empty());
    CHECK(measured(tracers - 1).builds.empty());
}

TEST_CASE("Rays: given a stop within a repeat, then those before it are kept, and one is checked") {
    constexpr int builds = 4 * tracers, between = 2;  // after the builds, and before each kind
    const speed::SceneFigures figures = measured(builds + between + 2 * tracers + 1);
    CHECK(figures.builds.front().by_threads.front().repeats.size() == 4);
    REQUIRE(figures.kinds.size() == 1);
    REQUIRE(figures.kinds.front().tracers.size() == tracers);
    for (const speed::RayFigures& r : figures.kinds.front().tracers) {
        CHECK(r.by_threads.front().repeats.size() == 2);
        CHECK(r.by_threads.front().ratio.median > 0);
        CHECK(r.errors.sample.rays == 1);
    }
    CHECK(measured(builds + between + tracers - 1).kinds.empty());
}

TEST_CASE("A curve: given a stop among its seeds, then it is the mean of those before it") {
    const bench::NamedScene named = bench::bench_scene("spheres:50");
    RenderSettings settings = named.settings;
    settings.resolution = {8, 8};
    convergence::ConvergenceConfig config;
    config.samplers = {"sobol"};
    config.samples = 4;
    config.seeds = 1000;
    std::atomic<bool> stop = false;
    int seeds = 0;
    const convergence::RunProgress run{stop, [&](double) { stop = ++seeds == 2; }};
    const std::vector<convergence::Curve> curves = convergence::measure(
        *named.scene, settings, {std::vector<Color>(64), "black"}, config, run);
    REQUIRE(curves.size() == 1);
    CHECK(curves.front().points.size() == 3);
    CHECK(curves.front().seeds == 2);
    CHECK(curves.front().points.back().mean_difference_error.has_value());
}
