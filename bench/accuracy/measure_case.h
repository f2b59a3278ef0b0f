// Traces the rays of a hard case with all tracers and sums up their errors.
#pragma once

#include <atomic>

#include "bench/accuracy/error_stats.h"
#include "bench/hard_cases/hard_case.h"
#include "core/intersect/intersector.h"

namespace etalon::accuracy {

struct Budget {
    std::uint64_t rays = 100'000;  ///< for each case
    double seconds = infinity;     ///< wall time for each case, after which no more rays are begun
    /// Upper bound on the number of ray-primitive tests where every ray is tested against every
    /// primitive; the number of rays is reduced to stay below it.
    std::uint64_t tests = 1'000'000'000;
    const std::atomic<bool>* stop = nullptr;  ///< if set, begin no more rays
    bool textbooks = true;  ///< also measure textbook kernels and the project's own kernels alone
};

/// Returns a row for each backend and, if the scene is one primitive, for its kernels, in the order
/// in which they are named. Uses all threads.
std::vector<Row> measure(const hard::HardCase& hard_case,
                         const std::vector<const Backend*>& backends, const Budget& budget);

}  // namespace etalon::accuracy
