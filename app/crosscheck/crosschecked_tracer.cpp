#include "app/crosscheck/crosschecked_tracer.h"

#include "app/common/backends.h"
#include "app/common/stopwatch.h"

namespace etalon::crosscheck {
namespace {

Answers trace(const Intersector& intersector, const std::vector<Ray>& rays,
              const std::atomic<bool>& stop) {
    Answers answers{std::vector<Answer>(rays.size())};
    Stopwatch watch;
    for (std::size_t i = 0; i < rays.size() && !stop; ++i) {
        answers.all[i].closest = intersector.closest(rays[i]);
    }
    answers.seconds = watch.lap().cpu;
    for (std::size_t i = 0; i < rays.size() && !stop; ++i) {
        answers.all[i].occluded = intersector.occluded(rays[i]);
    }
    return answers;
}

}  // namespace

std::optional<CrosscheckedTracer> trace(const std::string& backend, const Scene& scene,
                                        const std::vector<Trial>& trials,
                                        const CrosscheckProgress& run) {
    const Backend* found = find_backend(backend);
    const auto intersector = found->build(scene.geometry);
    CrosscheckedTracer tracer{backend, found->exact, {}};
    for (const Trial& trial : trials) {
        tracer.answers.push_back(trace(*intersector, trial.rays, run.stop));
    }
    if (run.stop) return std::nullopt;
    return tracer;
}

}  // namespace etalon::crosscheck
