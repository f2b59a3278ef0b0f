#include "app/crosscheck/trial.h"

#include "app/common/backends.h"
#include "core/parallel/parallel.h"

namespace etalon::crosscheck {
namespace {

constexpr const char* kinds[] = {"camera", "bounce", "shadow", "aimed"};  // few chords are hard

/// Removes the rays to which a stop left no answer.
Trial answered(const RaySet& set, const std::vector<std::optional<OracleAnswer>>& answers,
               double size) {
    Trial trial{set.kind, {}, {}, size};
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (!answers[i]) continue;
        trial.rays.push_back(set.rays[i]);
        trial.truth.push_back(*answers[i]);
    }
    return trial;
}

/// Returns the oracle's answers, until a stop. `done` kinds of ray were answered before.
Trial answered_trial(const Oracle& oracle, const RaySet& set, double size, std::size_t done,
                     const CrosscheckProgress& run) {
    std::vector<std::optional<OracleAnswer>> answers(set.rays.size());
    std::atomic<std::size_t> count = 0;
    parallel_for(set.rays.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !run.stop; ++i) {
            answers[i] = oracle.closest(set.rays[i]);
        }
        const auto part = static_cast<double>(count += end - begin);
        run.progress((static_cast<double>(done) + part / static_cast<double>(set.rays.size())) /
                     static_cast<double>(std::size(kinds)));
    });
    return answered(set, answers, size);
}

}  // namespace

std::vector<Trial> make_trials(const Scene& scene, const Imath::V2i& resolution, std::size_t limit,
                               const CrosscheckProgress& run) {
    run.begin("oracle");
    const auto exact = find_backend(default_backend)->build(scene.geometry);
    const Oracle oracle(scene.geometry);
    const double size = half_size(scene.geometry);
    std::vector<Trial> trials;
    for (const char* kind : kinds) {
        const RaySet set = make_ray_set(kind, scene, resolution, *exact, limit);
        Trial trial = answered_trial(oracle, set, size, trials.size(), run);
        if (run.stop && trial.rays.empty()) break;
        trials.push_back(std::move(trial));
        if (run.stop) break;
    }
    return trials;
}

}  // namespace etalon::crosscheck
