// The rays that a backend answers worst, as input of `etalon trace`.
#pragma once

#include "app/crosscheck/crosschecked_tracer.h"

namespace etalon::crosscheck {

struct WorstRay {
    std::string kind;    ///< kind of ray
    std::string wrong;   ///< description of the error
    std::string oracle;  ///< oracle's answer as trace would print it, without the normal
    std::string found;   ///< the backend's answer, likewise
    Ray ray;
};

/// Returns up to `limit` of the rays that the tracer answers wrongly: first those with a wrong hit
/// or miss, then a wrong occlusion, then a wrong primitive, then a wrong t, then other bits than
/// another exact backend; of these the ones with the largest error of t. If none is wrong, returns
/// those with the largest errors of t.
std::vector<WorstRay> worst_rays(const Scene& scene, const std::vector<Trial>& trials,
                                 const CrosscheckedTracer& tracer, std::size_t limit);

/// Returns two lines: the error as a comment, and the ray in hexadecimal floats, which are exact.
std::string trace_lines(const WorstRay& worst);

}  // namespace etalon::crosscheck
