// Counts of one backend's right and wrong answers to many rays.
#pragma once

#include "app/crosscheck/classification.h"

namespace etalon::crosscheck {

/// Counts of rays. Those that the oracle cannot decide are only in the first two and in
/// `differences`.
struct CrosscheckCounts {
    std::size_t rays = 0, undecidable = 0;
    std::size_t class_errors = 0, primitive_errors = 0, t_errors = 0,
                occlusion_errors = 0;  ///< see Classification
    std::size_t differences = 0;       ///< answers unlike those of another exact backend
    std::vector<double> t_ulp;         ///< errors of hits on the right primitive, ascending
    double seconds = 0;

    bool clean() const {
        return class_errors + primitive_errors + t_errors + occlusion_errors + differences == 0;
    }

    /// Returns the quantile `q` of the errors of t; 0 without a hit.
    double t_quantile(double q) const;
};

/// Counts the answers of a backend; see Backend for `exact`.
CrosscheckCounts counts_of(const Trial& trial, const Answers& answers, bool exact);

/// Returns the sum of all counts.
CrosscheckCounts sum(const std::vector<CrosscheckCounts>& all_counts);

}  // namespace etalon::crosscheck
