#include "app/crosscheck/trial.h"

#include "app/common/backends.h"
#include "core/parallel/parallel.h"

namespace etalon::crosscheck {
namespace {

std::vector<OracleAnswer> ask(const Oracle& oracle, const std::vector<Ray>& rays) {
    std::vector<OracleAnswer> answers(rays.size());
    parallel_for(rays.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) answers[i] = oracle.closest(rays[i]);
    });
    return answers;
}

}  // namespace

std::vector<Trial> make_trials(const Scene& scene, const Imath::V2i& resolution,
                               std::size_t limit) {
    const auto exact = find_backend(default_backend)->build(scene.geometry);
    const Oracle oracle(scene.geometry);
    std::vector<Trial> trials;
    for (const char* kind : {"camera", "bounce", "shadow", "aimed"}) {  // few chords are hard cases
        RaySet set = make_ray_set(kind, scene, resolution, *exact, limit);
        auto truth = ask(oracle, set.rays);
        trials.push_back({set.kind, std::move(set.rays), std::move(truth)});
    }
    return trials;
}

}  // namespace etalon::crosscheck
