// Totals of one tracer over several scenes and kinds of rays.
#pragma once

#include <cstdint>
#include <span>

#include "bench/speed/figures.h"

namespace etalon::speed {

/// Wrong answers among those that the oracle checked.
struct CheckedAnswers {
    void add(const OracleCheck& check) {
        rays += check.rays;
        wrong += check.errors();
    }

    std::uint64_t rays = 0, wrong = 0;
};

struct Totals {
    std::string tracer;
    std::vector<double> ratios, robust_ratios;  ///< on one thread, for each scene and kind of rays
    CheckedAnswers sampled;                     ///< rays spread evenly over all
    CheckedAnswers disputed;                    ///< rays for which tracers differ
};

/// Returns the totals of every tracer, in order of appearance.
std::vector<Totals> totals_of(std::span<const SceneFigures> scenes);

}  // namespace etalon::speed
