// Classification of answers as right or wrong.
#pragma once

#include "app/crosscheck/crosschecked_tracer.h"

namespace etalon::crosscheck {

struct Classification {
    bool decided = true;           ///< false: the oracle cannot decide; only `differs` is known
    bool wrong_class = false;      ///< a hit instead of a miss, or the reverse
    bool wrong_primitive = false;  ///< not the nearest one
    bool wrong_t = false;  ///< the nearest one, but its t is off by more than precision explains
    bool wrong_occlusion = false;  ///< occluded() is wrong
    bool differs = false;          ///< see Answer
    double t_ulp = 0;  ///< error of t in ulp of double, if there is a hit and one was found

    /// Returns whether the oracle agrees, or cannot decide.
    bool right() const { return !wrong_class && !wrong_primitive && !wrong_t && !wrong_occlusion; }
};

/// Classifies an answer to a ray of the trial. The t of an exact backend must be as good as
/// OracleAnswer::exact_limit(), and that of another as root_limit().
Classification classify(const Trial& trial, std::size_t ray, const Answer& answer, bool exact);

}  // namespace etalon::crosscheck
