// Backends that trace the rays of a cross-check.
#pragma once

#include "app/crosscheck/trial.h"

namespace etalon::crosscheck {

/// Answer of a backend to one ray.
struct Answer {
    std::optional<Hit> closest;
    bool occluded = false;
};

/// A backend's answers to the rays of one trial, in their order.
struct Answers {
    std::vector<Answer> all;
    double seconds = 0;  ///< processor time of closest(), one thread
};

struct CrosscheckedTracer {
    std::string name;
    bool exact;                    ///< see Backend
    std::vector<Answers> answers;  ///< one for each trial
};

/// Returns the backend's answers to all rays; nothing if it was stopped before the last one.
std::optional<CrosscheckedTracer> trace(const std::string& backend, const Scene& scene,
                                        const std::vector<Trial>& trials,
                                        const CrosscheckProgress& run);

}  // namespace etalon::crosscheck
