#include "app/crosscheck/crosscheck_results.h"

#include <algorithm>

namespace etalon::crosscheck {
namespace {

BackendResults results_of(const Scene& scene, const std::vector<Trial>& trials,
                          const CrosscheckedTracer& tracer, std::size_t worst) {
    BackendResults results{tracer.name, tracer.exact, {}, {}, {}};
    for (std::size_t t = 0; t < trials.size(); ++t) {
        results.by_kind.push_back(counts_of(trials[t], tracer.answers[t], tracer.exact));
    }
    results.total = sum(results.by_kind);
    results.worst = worst_rays(scene, trials, tracer, worst);
    return results;
}

/// Seconds for the backends to trace the rays that a stopped oracle has answered.
constexpr double seconds_after_stop = 5;

/// Traces the rays with the backends, until a stop. If the oracle was stopped there are few rays,
/// and the backends that do not trace all of them soon are left out.
std::vector<CrosscheckedTracer> trace_all(const CrosscheckConfig& config, const Scene& scene,
                                          const std::vector<Trial>& trials,
                                          const CrosscheckProgress& run) {
    static const std::atomic<bool> never = false;
    const bool is_late = run.stop;
    const Deadline deadline = is_late ? Deadline(seconds_after_stop) : Deadline();
    std::vector<CrosscheckedTracer> tracers;
    if (trials.empty()) return tracers;
    run.begin("backends");
    for (const std::string& name : config.backends) {
        std::optional<CrosscheckedTracer> tracer =
            trace(name, scene, trials, is_late ? never : run.stop, deadline);
        if (!tracer) break;
        const auto other = std::ranges::find(tracers, true, &CrosscheckedTracer::exact);
        if (tracer->exact && other != tracers.end()) mark_differences(*tracer, *other);
        tracers.push_back(std::move(*tracer));
        run.progress(static_cast<double>(tracers.size()) /
                     static_cast<double>(config.backends.size()));
    }
    return tracers;
}

}  // namespace

bool Results::as_promised() const {
    return std::all_of(backends.begin(), backends.end(),
                       [](const auto& b) { return !b.exact || b.total.clean(); });
}

Results crosscheck(const Scene& scene, const Imath::V2i& resolution, const CrosscheckConfig& config,
                   const CrosscheckProgress& run) {
    const std::vector<Trial> trials = make_trials(scene, resolution, config.rays, run);
    const bool stopped_oracle = run.stop;
    const std::vector<CrosscheckedTracer> tracers = trace_all(config, scene, trials, run);
    Results results;
    results.stopped = stopped_oracle || tracers.size() < config.backends.size();
    for (const Trial& trial : trials) results.kinds.push_back(trial.kind);
    for (const CrosscheckedTracer& c : tracers) {
        results.backends.push_back(results_of(scene, trials, c, config.worst));
    }
    results.contingencies = contingencies(trials, tracers);
    return results;
}

}  // namespace etalon::crosscheck
