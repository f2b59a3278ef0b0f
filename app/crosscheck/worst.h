// The rays that a backend answers worst, for `etalon trace` to ask again.
#pragma once

#include "app/crosscheck/classification.h"

namespace etalon::crosscheck {

struct WorstRay {
    std::string kind;    ///< of ray
    std::string wrong;   ///< in words
    std::string oracle;  ///< its answer as trace would print it, without the normal
    std::string found;   ///< the backend's, likewise
    Ray ray;
};

/// Returns up to `limit` of the rays that the tracer answers wrongly: first those where hit or miss
/// is wrong, then occlusion, then the primitive; of these the ones whose t is furthest off. If
/// there is none, returns those with the largest errors of t.
std::vector<WorstRay> worst_rays(const Scene& scene, const std::vector<Trial>& trials,
                                 const Tracer& tracer, std::size_t limit);

/// Two lines: what is wrong, as a comment, and the ray in hexadecimal floats, so to the bit.
std::string trace_lines(const WorstRay& worst);

}  // namespace etalon::crosscheck
