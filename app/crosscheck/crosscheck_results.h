// Results of a cross-check.
#pragma once

#include "app/crosscheck/contingency.h"
#include "app/crosscheck/crosscheck_counts.h"
#include "app/crosscheck/worst.h"

namespace etalon::crosscheck {

struct BackendResults {
    std::string name;
    bool exact;                             ///< see Backend
    std::vector<CrosscheckCounts> by_kind;  ///< one for each kind of ray
    CrosscheckCounts total;
    std::vector<WorstRay> worst;
};

struct Results {
    std::vector<std::string> kinds;  ///< kinds of rays
    std::vector<BackendResults> backends;
    std::vector<Contingency> contingencies;
    bool stopped = false;  ///< not all rays were traced, or not with all backends

    /// Returns whether all backends that promise to be exact are.
    bool as_promised() const;
};

struct CrosscheckConfig {
    std::vector<std::string> backends;
    std::size_t rays = 1000;  ///< approximate number of each kind
    std::size_t worst = 5;    ///< number of rays kept for each backend
};

/// Compares the backends with the oracle, and the exact ones with the first of them. A stop during
/// the oracle's work leaves fewer rays, which are then traced with all backends; a later stop
/// leaves fewer backends.
Results crosscheck(const Scene& scene, const Imath::V2i& resolution, const CrosscheckConfig& config,
                   const CrosscheckProgress& run);

}  // namespace etalon::crosscheck
