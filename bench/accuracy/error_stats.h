// Errors of a tracer on a hard case.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace etalon::accuracy {

/// Histogram of non-negative values in buckets a sixteenth of an octave wide, with the exact
/// maximum. It gives quantiles of any number of values in the space of a few hundred, since those
/// of a case lie in few octaves.
class Distribution {
  public:
    void add(double value);
    Distribution& operator+=(const Distribution& other);

    /// Returns the quantile `q` of the values, to within a bucket; 0 if there are none.
    double quantile(double q) const;
    double max() const { return max_; }
    std::uint64_t count() const { return count_; }

  private:
    static constexpr int steps = 16;
    std::map<int, std::uint64_t> buckets_;  ///< b holds the values up to 2^(b / steps)
    std::uint64_t count_ = 0, zeros_ = 0;
    double max_ = 0;
};

/// Sums over rays. `rays` are those that were checked; the oracle cannot decide the `undecidable`.
struct ErrorStats {
    ErrorStats& operator+=(const ErrorStats& other);

    std::uint64_t rays = 0, undecidable = 0;
    std::uint64_t false_hits = 0, false_misses = 0;
    std::uint64_t wrong_primitives = 0;  ///< not the nearest, or at a tie not the lowest
    /// Hits of the right primitive with t off by more than OracleAnswer::root_limit(), or for exact
    /// tracers exact_limit().
    std::uint64_t wrong_roots = 0;
    std::uint64_t leaks = 0;      ///< rays that leave a closed surface
    std::uint64_t self_hits = 0;  ///< spawned rays that hit the surface they left
    std::uint64_t contradictions =
        0;                         ///< occluded() contradicts closest(), on a quarter of the rays
    std::uint64_t deviations = 0;  ///< bits that differ from the first exact tracer's
    Distribution float_ulps;       ///< |t - true t| in ulp of a float at the true t
    Distribution double_ulps;      ///< the same in ulp of a double
    /// |t - true t| relative to the change of t if every input moves by one unit roundoff: the K of
    /// "K u kappa".
    Distribution conditioned;
    Distribution position;  ///< |P - true P| / size, for the P that shading uses
    Distribution shift;     ///< |spawned origin - P| / size

    /// Returns the number of rays whose right answer is known.
    std::uint64_t decided() const { return rays - undecidable; }

    /// Returns the sum of everything that must be zero for an exact tracer.
    std::uint64_t errors() const {
        return false_hits + false_misses + wrong_roots + wrong_primitives + leaks + self_hits +
               contradictions + deviations;
    }
};

/// One line of the report.
struct Row {
    std::string id, variant, shape, criterion, tracer;
    bool exact = false;  ///< the tracer promises to be exact
    ErrorStats stats;
    double nanoseconds = 0;  ///< per ray, median over blocks of rays, CPU time
    double cost = 0;         ///< relative to the first textbook kernel on the same rays; 0 if none
    bool partial = false;  ///< fewer rays than planned: stopped, out of time, or see Budget::tests
};

}  // namespace etalon::accuracy
