#include "bench/speed/measured_rays.h"

#include <algorithm>

#include "bench/speed/alternate.h"

namespace etalon::speed {
namespace {

/// Returns an exact backend that shares no tree with the one compared with it.
std::string reference_of(const std::string& tracer) {
    return tracer == second_backend ? default_backend : second_backend;
}

const TimedTracer* find(const std::vector<TimedTracer>& list, const std::string& name) {
    const auto found = std::find_if(list.begin(), list.end(),
                                    [&](const TimedTracer& c) { return c.name() == name; });
    return found == list.end() ? nullptr : &*found;
}

}  // namespace

RayMeasurement::RayMeasurement(const hard::CaseSetup& setup,
                               const std::vector<TimedTracer>& tracers, const SpeedConfig& config)
    : setup_(setup), tracers_(tracers), config_(config), oracle_(setup.scene.geometry) {
    for (const std::string name : {default_backend, second_backend}) {
        if (find(tracers, name) != nullptr) continue;
        const Backend& backend = find_tracer(name);
        references_.push_back({&backend, backend.build(setup.scene.geometry)});
    }
}

const TimedTracer& RayMeasurement::tracer_named(const std::string& name) const {
    const TimedTracer* tracer = find(tracers_, name);
    return tracer != nullptr ? *tracer : *find(references_, name);
}

std::optional<KindFigures> RayMeasurement::measure(const RaySet& set,
                                                   const std::function<bool()>& is_over) const {
    Answers answers(tracers_.size(), std::vector<Answer>(set.rays.size(), missed));
    KindFigures figures{set.kind, set.rays.size(), set.occlusion, time(set, is_over, answers)};
    if (figures.tracers.empty()) return std::nullopt;
    find_errors(set, answers, is_over, figures);
    return figures;
}

/// Returns nothing if it was over before the first repeat was complete.
std::vector<RayFigures> RayMeasurement::time(const RaySet& set,
                                             const std::function<bool()>& is_over,
                                             Answers& answers) const {
    std::vector<RayFigures> all(tracers_.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].tracer = tracers_[i].name();
        all[i].by_threads = runs_on(config_.threads);
    }
    const std::size_t numbers_of_threads = config_.threads.size();
    const auto trace_once = [&](int, std::size_t k) {
        const std::size_t i = k / numbers_of_threads;
        const Intersector& intersector = *tracers_[i].intersector;
        Runs& runs = all[i].by_threads[k % numbers_of_threads];
        runs.repeats.push_back(trace(intersector, set, runs.threads, answers[i]));
    };
    const int repeats =
        alternate(config_.repeats, tracers_.size() * numbers_of_threads, is_over, trace_once);
    if (repeats == 0) return {};
    keep_repeats(all, repeats);
    compare_with_baselines(all);
    return all;
}

std::vector<Answer> RayMeasurement::answers_of(const std::string& name, const RaySet& set,
                                               const Answers& answers) const {
    for (std::size_t i = 0; i < tracers_.size(); ++i) {
        if (tracers_[i].name() == name) return answers[i];
    }
    std::vector<Answer> found(set.rays.size(), missed);
    trace(*tracer_named(name).intersector, set, 1, found);
    return found;
}

OracleReferences RayMeasurement::oracle_references(const RaySet& set,
                                                   const std::vector<std::size_t>& places,
                                                   const std::function<bool()>& is_over) const {
    return {setup_, oracle_, set, places, config_.oracle_seconds, is_over};
}

/// Returns the disputed rays in an order of which every prefix is spread evenly over them, as time
/// may not suffice for all.
std::vector<std::size_t> RayMeasurement::disputed_rays(const RaySet& set, const Answers& answers) {
    const std::vector<std::size_t> places = disputed(answers, set.occlusion);
    std::vector<std::size_t> order;
    for (const std::size_t i : scattered(places.size())) order.push_back(places[i]);
    return order;
}

void RayMeasurement::find_errors(const RaySet& set, const Answers& answers,
                                 const std::function<bool()>& is_over, KindFigures& figures) const {
    const std::vector<Answer> first = answers_of(default_backend, set, answers);
    const std::vector<Answer> second = answers_of(second_backend, set, answers);
    const OracleReferences sample = oracle_references(set, scattered(set.rays.size()), is_over);
    const OracleReferences disputed = oracle_references(set, disputed_rays(set, answers), is_over);
    for (std::size_t i = 0; i < tracers_.size(); ++i) {
        Errors& errors = figures.tracers[i].errors;
        errors.reference = reference_of(tracers_[i].name());
        errors.disagreement = compare(
            answers[i], errors.reference == default_backend ? first : second, set.occlusion);
        errors.sample = sample.check(answers[i], tracers_[i].backend->exact);
        errors.disputed = disputed.check(answers[i], tracers_[i].backend->exact);
    }
}

}  // namespace etalon::speed
