#include "app/crosscheck/crosscheck_results.h"

#include <algorithm>

namespace etalon::crosscheck {
namespace {

BackendResults results_of(const Scene& scene, const std::vector<Trial>& trials,
                          const Tracer& tracer, std::size_t worst) {
    BackendResults results{tracer.name, tracer.exact, {}, {}, {}};
    for (std::size_t t = 0; t < trials.size(); ++t) {
        results.by_kind.push_back(counts_of(trials[t], tracer.answers[t]));
    }
    results.total = sum(results.by_kind);
    results.worst = worst_rays(scene, trials, tracer, worst);
    return results;
}

}  // namespace

bool Results::as_promised() const {
    return std::all_of(backends.begin(), backends.end(),
                       [](const auto& b) { return !b.exact || b.total.clean(); });
}

Results crosscheck(const Scene& scene, const Imath::V2i& resolution,
                   const std::vector<std::string>& backends, std::size_t rays, std::size_t worst) {
    const std::vector<Trial> trials = make_trials(scene, resolution, rays);
    std::vector<Tracer> tracers;
    for (const std::string& name : backends) tracers.push_back(ask(name, scene, trials));
    Results results;
    for (const Trial& trial : trials) results.kinds.push_back(trial.kind);
    for (const Tracer& c : tracers) {
        results.backends.push_back(results_of(scene, trials, c, worst));
    }
    results.contingencies = contingencies(trials, tracers);
    return results;
}

}  // namespace etalon::crosscheck
