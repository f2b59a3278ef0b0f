#include "app/crosscheck/crosschecked_tracer.h"

#include "app/common/backends.h"
#include "app/common/stopwatch.h"
#include "core/numerics/same_bits.h"

namespace etalon::crosscheck {
namespace {

/// Rays between two looks at the clock, which take longer than these.
constexpr std::size_t often = 64;

/// Returns the answers to all rays; nothing if it was over before the last one.
template <class Test>
std::optional<Answers> trace(const Intersector& intersector, const std::vector<Ray>& rays,
                             const Test& is_over) {
    Answers answers{std::vector<Answer>(rays.size())};
    Stopwatch watch;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (i % often == 0 && is_over()) return std::nullopt;
        answers.all[i].closest = intersector.closest(rays[i]);
    }
    answers.seconds = watch.lap().cpu;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (i % often == 0 && is_over()) return std::nullopt;
        answers.all[i].occluded = intersector.occluded(rays[i]);
    }
    return answers;
}

bool same(const Answer& a, const Answer& b) {
    if (a.occluded != b.occluded || a.closest.has_value() != b.closest.has_value()) return false;
    return !a.closest ||
           (same_bits(a.closest->t, b.closest->t) && a.closest->primitive == b.closest->primitive &&
            a.closest->instance == b.closest->instance);
}

}  // namespace

std::optional<CrosscheckedTracer> trace(const std::string& backend, const Scene& scene,
                                        const std::vector<Trial>& trials,
                                        const std::atomic<bool>& stop, const Deadline& deadline) {
    const Backend* found = find_backend(backend);
    const auto intersector = found->build(scene.geometry);
    CrosscheckedTracer tracer{backend, found->exact, {}};
    for (const Trial& trial : trials) {
        std::optional<Answers> answers =
            trace(*intersector, trial.rays, [&] { return stop || deadline.is_over(); });
        if (!answers) return std::nullopt;
        tracer.answers.push_back(std::move(*answers));
    }
    return tracer;
}

void mark_differences(CrosscheckedTracer& tracer, const CrosscheckedTracer& other) {
    for (std::size_t t = 0; t < tracer.answers.size(); ++t) {
        for (std::size_t i = 0; i < tracer.answers[t].all.size(); ++i) {
            Answer& answer = tracer.answers[t].all[i];
            answer.differs = !same(answer, other.answers[t].all[i]);
        }
    }
}

}  // namespace etalon::crosscheck
