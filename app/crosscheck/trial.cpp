#include "app/crosscheck/trial.h"

#include "app/backends.h"
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

std::vector<Trial> make_trials(const Scene& scene, std::size_t limit) {
    const auto exact = find_backend("bvh")->build(scene);
    const Oracle oracle(scene);
    std::vector<Trial> trials;
    for (RaySet& set : make_ray_sets(scene, *exact, limit)) {
        if (set.kind == "random") continue;  // hardly any comes near what is hard to decide
        auto truth = ask(oracle, set.rays);
        trials.push_back({set.kind, std::move(set.rays), std::move(truth)});
    }
    return trials;
}

}  // namespace etalon::crosscheck
