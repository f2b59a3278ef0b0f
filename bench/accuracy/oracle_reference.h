// Comparison of answers with those of the oracle.
#pragma once

#include <array>

#include "bench/accuracy/error_stats.h"
#include "bench/accuracy/tracer.h"
#include "bench/hard_cases/hard_case.h"
#include "core/oracle/oracle.h"

namespace etalon::accuracy {

/// A tracer and its guarantees.
struct TracerEntry {
    std::unique_ptr<Tracer> tracer;
    bool exact = false;    ///< hits are right, with the same bits as every other exact tracer's
    bool refined = false;  ///< positions are moved onto the surface, as in the renderer
};

/// A number of far more digits than a double has, as a double and the remainder. Quad precision is
/// slow, and the number is needed a hundred times for every ray.
class Remainder {
  public:
    Remainder() = default;
    explicit Remainder(Quad x)
        : high_(static_cast<double>(x)), low_(static_cast<double>(x - high_)) {}

    double distance(double x) const { return std::abs((x - high_) - low_); }

  private:
    double high_ = 0, low_ = 0;
};

/// The oracle's answer to one ray, with data that the comparison needs.
class OracleReference {
  public:
    OracleReference(const hard::CaseSetup& setup, const Oracle& oracle, const Ray& ray);

    void classify(const TracerEntry& entry, const Answer& answer, ErrorStats& stats) const;

  private:
    void classify_distance(const TracerEntry& entry, const Answer& answer, ErrorStats& stats) const;
    /// Returns the largest error of a right t.
    double largest_error(const TracerEntry& entry) const;
    bool is_right_primitive(const TracerEntry& entry, const Answer& answer) const;
    HitKey lowest_of_the_nearest() const;

    const hard::CaseSetup& setup_;
    const Ray& ray_;
    OracleAnswer answer_;
    Remainder t_;                        ///< t of the oracle's hit
    std::array<Remainder, 3> position_;  ///< position of that hit
    double sensitivity_ = 0;  ///< change of t when every input moves by one unit roundoff
};

}  // namespace etalon::accuracy
