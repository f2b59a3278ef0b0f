#include "bench/speed/timed_tracer.h"

#include <algorithm>

#include "app/common/backends.h"
#include "bench/speed/alternate.h"
#include "bench/speed/pinned.h"
#include "core/parallel/parallel.h"
#include "embree_backend/embree_backends.h"

namespace etalon::speed {
namespace {

Duration time_build(TimedTracer& tracer, const Scene& scene, int threads) {
    const ThreadLimit limit(threads);
    const auto build = [&] { tracer.intersector = tracer.backend->build(scene.geometry); };
    tracer.intersector.reset();
    if (threads == 1) return run_pinned(1, build);
    Stopwatch watch;
    build();
    return watch.lap();
}

}  // namespace

std::vector<std::string> tracer_names() {
    std::vector<std::string> names = backend_names();
    names.emplace_back(embree_builtin_robust().name);
    return names;
}

const Backend& find_tracer(const std::string& name) {
    const Backend* backend = find_backend(name);
    return backend == nullptr ? embree_builtin_robust() : *backend;
}

std::vector<std::string> with_baselines(const std::vector<std::string>& requested) {
    std::vector<std::string> names = tracer_names();
    std::erase_if(names, [&](const std::string& name) {
        return name != baseline && name != robust_baseline &&
               std::find(requested.begin(), requested.end(), name) == requested.end();
    });
    return names;
}

std::vector<BuildFigures> measure_builds(std::vector<TimedTracer>& tracers, const Scene& scene,
                                         const SpeedConfig& config,
                                         const std::function<bool()>& is_over) {
    const std::vector<int>& threads = config.threads;
    std::vector<BuildFigures> all(tracers.size());
    for (BuildFigures& figures : all) figures.by_threads = runs_on(threads);
    const auto build = [&](int, std::size_t k) {
        const std::size_t tracer = k / threads.size(), run = k % threads.size();
        const Duration seconds = time_build(tracers[tracer], scene, threads[run]);
        all[tracer].by_threads[run].repeats.push_back(seconds);
    };
    const int repeats = alternate(config.repeats, tracers.size() * threads.size(), is_over, build);
    if (repeats == 0) return {};
    keep_repeats(all, repeats);
    for (std::size_t i = 0; i < tracers.size(); ++i) {
        const Intersector& built = *tracers[i].intersector;
        all[i].tracer = tracers[i].name();
        all[i].isa = built.isa();
        const std::size_t count = std::max<std::size_t>(scene.geometry.item_count(), 1);
        all[i].bytes_per_primitive =
            static_cast<double>(built.memory_bytes()) / static_cast<double>(count);
    }
    compare_with_baselines(all);
    return all;
}

}  // namespace etalon::speed
