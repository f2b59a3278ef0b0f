// Errors of a tracer on a hard case.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace etalon::accuracy {

/// Counts of non-negative values in buckets a sixteenth of an octave wide, with the exact maximum:
/// quantiles of any number of values in a fixed space.
class Distribution {
  public:
    void add(double value);
    Distribution& operator+=(const Distribution& other);

    /// The value that a share `q` of all do not exceed, to within a bucket; 0 if there are none.
    double quantile(double q) const;
    double max() const { return max_; }
    std::uint64_t count() const { return count_; }

  private:
    static constexpr int octaves = 128, steps = 16;
    std::array<std::uint64_t, octaves * steps + 1> buckets_{};
    std::uint64_t count_ = 0;
    double max_ = 0;
};

/// Sums over rays. `rays` counts those judged; the oracle decides none of the `undecidable`.
struct ErrorStats {
    ErrorStats& operator+=(const ErrorStats& other);

    std::uint64_t rays = 0, undecidable = 0;
    std::uint64_t false_hits = 0, false_misses = 0;
    std::uint64_t wrong_roots = 0;       ///< right to hit, but off by more than 1e-2 of the size
    std::uint64_t wrong_primitives = 0;  ///< another than the nearest, or at a tie not the lowest
    std::uint64_t leaks = 0;             ///< rays that get out of a closed surface
    std::uint64_t self_hits = 0;         ///< spawned rays that meet the surface they left
    std::uint64_t contradictions =
        0;                         ///< occluded() says other than closest(), in a quarter of all
    std::uint64_t deviations = 0;  ///< other bits than those of the first exact tracer
    Distribution float_ulps;       ///< |t - true t| in ulp of a float at the true t
    Distribution double_ulps;      ///< the same in ulp of a double
    Distribution conditioned;      ///< |t - true t| in units of what moving every input by one unit
                                   ///< roundoff can do to t: the K of "K u kappa"
    Distribution position;         ///< |P - true P| / size, P as the shading gets it
    Distribution shift;            ///< |spawned origin - P| / size

    /// All that must be zero for a tracer that promises to be right.
    std::uint64_t errors() const {
        return false_hits + false_misses + wrong_roots + wrong_primitives + leaks + self_hits +
               contradictions + deviations;
    }
};

/// One line of the report.
struct Row {
    std::string id, variant, shape, criterion, tracer;
    bool exact = false;  ///< the tracer promises to be right
    ErrorStats stats;
    double nanoseconds = 0;  ///< a ray, median over blocks of rays, CPU time
    double cost = 0;         ///< relative to the first textbook kernel on the same rays; 0 if none
    bool partial = false;    ///< fewer rays than asked for: stopped, or its time was up
};

}  // namespace etalon::accuracy
