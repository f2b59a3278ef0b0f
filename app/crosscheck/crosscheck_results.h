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

    /// Whether every backend that promises to be exact is.
    bool as_promised() const;
};

/// Asks the oracle and the backends of these names, and compares. About `rays` of each kind,
/// `worst` of them kept for each backend.
Results crosscheck(const Scene& scene, const Imath::V2i& resolution,
                   const std::vector<std::string>& backends, std::size_t rays, std::size_t worst);

}  // namespace etalon::crosscheck
