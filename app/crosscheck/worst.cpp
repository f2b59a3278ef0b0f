#include "app/crosscheck/worst.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "app/common/hit_text.h"
#include "app/crosscheck/classification.h"

namespace etalon::crosscheck {
namespace {

/// A ray of the trials with its answer.
struct Case {
    std::size_t trial, ray;
    Classification classification;

    bool graver_than(const Case& other) const { return rank() > other.rank(); }

  private:
    std::tuple<bool, bool, bool, bool, bool, double> rank() const {
        const Classification& v = classification;
        return {v.wrong_class, v.wrong_occlusion, v.wrong_primitive, v.wrong_t, v.differs, v.t_ulp};
    }
};

/// Returns the cases for whose classification `wanted` holds, in the order of the trials.
template <class F>
std::vector<Case> cases(const std::vector<Trial>& trials, const CrosscheckedTracer& tracer,
                        const F& wanted) {
    std::vector<Case> found;
    for (std::size_t t = 0; t < trials.size(); ++t) {
        for (std::size_t i = 0; i < trials[t].rays.size(); ++i) {
            const Classification classification =
                classify(trials[t], i, tracer.answers[t].all[i], tracer.exact);
            if (wanted(classification)) found.push_back({t, i, classification});
        }
    }
    return found;
}

std::string describe(const Scene& scene, const OracleAnswer& truth) {
    if (truth.kind == OracleAnswer::undecidable) return "undecidable";
    if (truth.kind != OracleAnswer::hit) return "miss";
    return hit_text(scene.geometry, {truth.t, truth.primitive, truth.instance});
}

std::string describe(const Scene& scene, const Answer& answer) {
    if (!answer.closest) return "miss";
    return hit_text(scene.geometry, *answer.closest);
}

std::string what_is_wrong(const Classification& v, const Answer& answer) {
    if (v.wrong_class) return answer.closest ? "hit where there is none" : "hit not found";
    if (v.wrong_occlusion) return answer.occluded ? "called occluded" : "not called occluded";
    if (v.wrong_primitive) return "not the nearest primitive";
    if (v.differs && !v.wrong_t) return "unlike another exact backend's answer";
    return fmt::format("t off by {:.3g} ulp", v.t_ulp);
}

}  // namespace

std::vector<WorstRay> worst_rays(const Scene& scene, const std::vector<Trial>& trials,
                                 const CrosscheckedTracer& tracer, std::size_t limit) {
    auto found =
        cases(trials, tracer, [](const Classification& v) { return !v.right() || v.differs; });
    if (found.empty()) {
        found = cases(trials, tracer, [](const Classification& v) { return v.t_ulp > 0; });
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Case& a, const Case& b) { return a.graver_than(b); });
    if (found.size() > limit) found.resize(limit);
    std::vector<WorstRay> worst;
    for (const Case& c : found) {
        const Trial& trial = trials[c.trial];
        const Answer& answer = tracer.answers[c.trial].all[c.ray];
        worst.push_back({trial.kind, what_is_wrong(c.classification, answer),
                         describe(scene, trial.truth[c.ray]), describe(scene, answer),
                         trial.rays[c.ray]});
    }
    return worst;
}

std::string trace_lines(const WorstRay& worst) {
    const Ray& r = worst.ray;
    const std::string time = r.time() == 0 ? "" : fmt::format(" {:a}", r.time() * 0x1p-24);
    return fmt::format(
        "# {} ray, {}: {}; the oracle: {}\n{:a} {:a} {:a} {:a} {:a} {:a} {:a} {:a}{}{}\n",
        worst.kind, worst.wrong, worst.found, worst.oracle, r.origin.x, r.origin.y, r.origin.z,
        r.direction.x, r.direction.y, r.direction.z, r.tmin, r.tmax, time,
        r.is_shadow() ? " shadow" : "");
}

}  // namespace etalon::crosscheck
