// Shoots the rays of a hard case at everyone and sums up how they fared.
#pragma once

#include <atomic>

#include "bench/accuracy/error_stats.h"
#include "bench/hard_cases/hard_case.h"
#include "core/intersect/intersector.h"

namespace etalon::accuracy {

struct Budget {
    std::uint64_t rays = 100'000;  ///< for each case
    double seconds = infinity;     ///< for each case, on the wall: then no more rays are begun
    /// Upper bound on the number of ray-primitive tests where every ray is tested against every
    /// primitive; the number of rays is reduced to stay below it.
    std::uint64_t tests = 1'000'000'000;
    const std::atomic<bool>* stop = nullptr;  ///< set: begin no more rays
    bool textbooks = true;  ///< kernels of textbooks, and the project's own by themselves, too
};

/// A row for each backend and, where the scene is one primitive, for its kernels, in the order in
/// which they are named; on all threads there are.
std::vector<Row> measure(const hard::HardCase& hard_case,
                         const std::vector<const Backend*>& backends, const Budget& budget);

}  // namespace etalon::accuracy
