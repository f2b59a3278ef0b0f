// Comparison of two backends: which is right where they differ.
#pragma once

#include "app/crosscheck/crosschecked_tracer.h"

namespace etalon::crosscheck {

/// Numbers of decided rays by which backend is right.
struct Contingency {
    std::string a, b;
    std::size_t both_right = 0, only_a_right = 0, only_b_right = 0, both_wrong = 0;

    /// Returns chi2 of one degree of freedom, without correction: how far the two are from being
    /// wrong equally often (McNemar 1947, "Note on the sampling error of the difference between
    /// correlated proportions or percentages", Psychometrika 12(2)). 0 if they never differ.
    double mcnemar() const;

    /// Returns a sentence that says which of the two is worse.
    std::string in_words() const;
};

Contingency contingency(const std::vector<Trial>& trials, const CrosscheckedTracer& a,
                        const CrosscheckedTracer& b);

/// Compares every pair of up to three tracers, else the first one with each of the others.
std::vector<Contingency> contingencies(const std::vector<Trial>& trials,
                                       const std::vector<CrosscheckedTracer>& tracers);

}  // namespace etalon::crosscheck
