#include "bench/speed/judgement.h"

#include <bit>

namespace etalon::speed {
namespace {

/// All numbers below `count` in an order of which every beginning is spread evenly over them: the
/// bits of 0, 1, 2, ... reversed (van der Corput 1935).
class Scattered {
  public:
    explicit Scattered(std::size_t count)
        : count_(count), bits_(static_cast<int>(std::bit_width(count))) {}

    /// The next one; `count` after the last.
    std::size_t next() {
        while (step_ < std::size_t{1} << bits_) {
            const std::size_t number = reversed(step_++);
            if (number < count_) return number;
        }
        return count_;
    }

  private:
    std::size_t reversed(std::size_t value) const {
        std::size_t result = 0;
        for (int b = 0; b < bits_; ++b) result |= (value >> b & 1) << (bits_ - 1 - b);
        return result;
    }

    std::size_t count_, step_ = 0;
    int bits_;
};

}  // namespace

Sample::Sample(const hard::Setting& setting, const Oracle& oracle, const RaySet& set,
               double seconds)
    : set_(set) {
    Stopwatch watch;
    Scattered order(set.rays.size());
    for (double spent = 0; rays_.empty() || spent < seconds; spent += watch.lap().cpu) {
        const std::size_t k = order.next();
        if (k >= set.rays.size()) return;
        rays_.push_back(k);
        if (set.occlusion) {
            is_occluded_.push_back(oracle.closest(set.rays[k], setting.tie).kind);
        } else {
            truth_.emplace_back(setting, oracle, set.rays[k]);
        }
    }
}

Judgement Sample::judge(std::span<const Answer> answers, bool exact) const {
    return set_.occlusion ? judge_occlusion(answers) : judge_closest(answers, exact);
}

Judgement Sample::judge_closest(std::span<const Answer> answers, bool exact) const {
    const accuracy::Entrant entrant{nullptr, exact, true};
    accuracy::Tally tally;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        truth_[i].judge(entrant, answers[rays_[i]], tally);
    }
    return {tally.rays,         tally.undecidable,      tally.false_hits,
            tally.false_misses, tally.wrong_primitives, tally.float_ulps.max()};
}

Judgement Sample::judge_occlusion(std::span<const Answer> answers) const {
    Judgement j;
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
