// All that a cross-check finds out.
#pragma once

#include "app/crosscheck/contingency.h"
#include "app/crosscheck/crosscheck_counts.h"
#include "app/crosscheck/worst.h"

namespace etalon::crosscheck {

struct BackendResults {
    std::string name;
    bool exact;                             ///< see Backend
    std::vector<CrosscheckCounts> by_kind;  ///< of ray
    CrosscheckCounts total;
    std::vector<WorstRay> worst;
};

struct Results {
    std::vector<std::string> kinds;  ///< of ray
    std::vector<BackendResults> backends;
    std::vector<Contingency> contingencies;
    bool stopped = false;  ///< not all rays were asked, or not all backends

    /// Returns whether every backend that promises to be exact is.
    bool as_promised() const;
};

struct Plan {
    std::vector<std::string> backends;
    std::size_t rays = 1000;  ///< of each kind, about
    std::size_t worst = 5;    ///< rays kept for each backend
};

/// Asks the oracle and the backends, and compares. A stop while the oracle is asked leaves fewer
/// rays, which all backends are then asked; one after that leaves fewer backends.
Results crosscheck(const Scene& scene, const Imath::V2i& resolution, const Plan& plan,
                   const RunControl& run);

}  // namespace etalon::crosscheck
