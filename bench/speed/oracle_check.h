// Checks by the oracle of as many rays as time allows.
#pragma once

#include <functional>

#include "bench/accuracy/oracle_reference.h"
#include "bench/speed/tracing.h"

namespace etalon::speed {

/// Numbers of errors; see accuracy::ErrorStats for their meanings.
struct OracleCheck {
    std::uint64_t rays = 0, undecidable = 0;
    std::uint64_t false_hits = 0, false_misses = 0;
    std::uint64_t wrong_primitives = 0, wrong_roots = 0;  ///< always 0 for occlusion queries
    double t_ulps = 0;                                    ///< largest error of t, in ulp of a float

    std::uint64_t errors() const {
        return false_hits + false_misses + wrong_primitives + wrong_roots;
    }
};

/// Returns all numbers below `count` in an order of which every prefix is spread evenly over them.
std::vector<std::size_t> scattered(std::size_t count);

/// Answers of the oracle to some of a set's rays, used for all tracers.
class OracleReferences {
  public:
    /// Asks the oracle about the rays with these indices in the set, in this order, for so many CPU
    /// seconds and until it is over, but at least about one. The setup and the set must outlive
    /// this.
    OracleReferences(
        const hard::CaseSetup& setup, const Oracle& oracle, const RaySet& set,
        const std::vector<std::size_t>& places, double seconds,
        const std::function<bool()>& is_over = [] { return false; });

    /// Checks a tracer's answers to the whole set; see TracerEntry for `exact`.
    OracleCheck check(std::span<const Answer> answers, bool exact) const;

  private:
    OracleCheck check_closest(std::span<const Answer> answers, bool exact) const;
    OracleCheck check_occlusion(std::span<const Answer> answers) const;

    const RaySet& set_;
    std::vector<std::size_t> rays_;                      ///< their indices in the set
    std::vector<accuracy::OracleReference> references_;  ///< one for each ray, for closest hits
    std::vector<OracleAnswer::Kind> is_occluded_;  ///< one for each ray, for occlusion queries
};

}  // namespace etalon::speed
