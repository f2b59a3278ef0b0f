// The tracers that answer the rays of a hard case, each timed on the same blocks of rays.
#pragma once

#include <vector>

#include "bench/accuracy/measure_case.h"
#include "bench/accuracy/oracle_reference.h"

namespace etalon::accuracy {

inline constexpr std::uint64_t block_size = 4096;  ///< rays

/// Measurements of one tracer over some blocks.
struct TracerResult {
    ErrorStats stats;
    std::vector<double> nanoseconds;  ///< per ray, one value for each block

    TracerResult& operator+=(const TracerResult& other) {
        stats += other.stats;
        nanoseconds.insert(nanoseconds.end(), other.nanoseconds.begin(), other.nanoseconds.end());
        return *this;
    }
};

class TimedTracers {
  public:
    /// Takes the backends that have kernels of their own for the scene and, if the budget has room
    /// for them, the kernels of the scene's only primitive. The setup must outlive the tracers.
    TimedTracers(const hard::HardCase& hard_case, const hard::CaseSetup& setup,
                 const std::vector<const Backend*>& backends, const Budget& budget);

    std::size_t size() const { return entries_.size(); }
    const TracerEntry& operator[](std::size_t k) const { return entries_[k]; }

    /// Returns every tracer's answers to the rays of a block, none from a tracer that no longer
    /// takes part, and adds to `results` its time and the errors that answers show without a
    /// reference: contradictions and deviations.
    std::vector<std::vector<Answer>> trace(const RayBlock& block, std::uint64_t block_number,
                                           std::vector<TracerResult>& results) const;

  private:
    void enter(std::unique_ptr<Tracer> tracer, bool exact, bool refined);
    bool takes_part(const TracerEntry& entry, std::uint64_t block_number) const;
    void count_deviations(const std::vector<std::vector<Answer>>& answers,
                          std::vector<TracerResult>& results) const;

    const std::size_t items_;  ///< of the scene
    const std::uint64_t most_tests_;
    std::vector<TracerEntry> entries_;
};

}  // namespace etalon::accuracy
