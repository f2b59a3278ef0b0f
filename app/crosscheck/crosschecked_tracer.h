// Backends that trace the rays of a cross-check.
#pragma once

#include "app/crosscheck/trial.h"
#include "core/render/deadline.h"

namespace etalon::crosscheck {

/// Answer of a backend to one ray.
struct Answer {
    std::optional<Hit> closest;
    bool occluded = false;
    bool differs = false;  ///< from another exact backend's answer; see mark_differences()
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

/// Returns the backend's answers to all rays; nothing if a stop or the deadline came before the
/// last one.
std::optional<CrosscheckedTracer> trace(const std::string& backend, const Scene& scene,
                                        const std::vector<Trial>& trials,
                                        const std::atomic<bool>& stop, const Deadline& deadline);

/// Marks the answers of an exact backend that differ in any bit from those of another, whether or
/// not the oracle can decide the ray.
void mark_differences(CrosscheckedTracer& tracer, const CrosscheckedTracer& other);

}  // namespace etalon::crosscheck
