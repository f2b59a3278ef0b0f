#include "bench/speed/oracle_check.h"

#include <bit>

namespace etalon::speed {
/// Van der Corput sequence: the reversed bits of 0, 1, 2, ... (1935).
std::vector<std::size_t> scattered(std::size_t count) {
    const int bits = static_cast<int>(std::bit_width(count));
    std::vector<std::size_t> order;
    for (std::size_t step = 0; step < std::size_t{1} << bits; ++step) {
        std::size_t number = 0;
        for (int b = 0; b < bits; ++b) number |= (step >> b & 1) << (bits - 1 - b);
        if (number < count) order.push_back(number);
    }
    return order;
}

OracleReferences::OracleReferences(const hard::CaseSetup& setup, const Oracle& oracle,
                                   const RaySet& set, const std::vector<std::size_t>& places,
                                   double seconds, const std::function<bool()>& is_over)
    : set_(set) {
    Stopwatch watch;
    double spent = 0;
    for (const std::size_t place : places) {
        if (!rays_.empty() && (spent >= seconds || is_over())) return;
        const Ray& ray = set.rays[place];
        rays_.push_back(place);
        if (set.occlusion) {
            is_occluded_.push_back(oracle.closest(ray, setup.tie).kind);
        } else {
            references_.emplace_back(setup, oracle, ray);
        }
        spent += watch.lap().cpu;
    }
}

OracleCheck OracleReferences::check(std::span<const Answer> answers, bool exact) const {
    return set_.occlusion ? check_occlusion(answers) : check_closest(answers, exact);
}

OracleCheck OracleReferences::check_closest(std::span<const Answer> answers, bool exact) const {
    const accuracy::TracerEntry entry{nullptr, exact, true};
    accuracy::ErrorStats stats;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        references_[i].classify(entry, answers[rays_[i]], stats);
    }
    return {stats.rays,
            stats.undecidable,
            stats.false_hits,
            stats.false_misses,
            stats.wrong_primitives,
            stats.wrong_roots,
            stats.float_ulps.max()};
}

OracleCheck OracleReferences::check_occlusion(std::span<const Answer> answers) const {
    OracleCheck j;
    j.rays = rays_.size();
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        const bool said = answers[rays_[i]].primitive != no_index;
        j.undecidable += is_occluded_[i] == OracleAnswer::undecidable;
        j.false_hits += is_occluded_[i] == OracleAnswer::miss && said;
        j.false_misses += is_occluded_[i] == OracleAnswer::hit && !said;
    }
    return j;
}

}  // namespace etalon::speed
