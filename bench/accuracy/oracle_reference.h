// Comparison of answers with those of the oracle.
#pragma once

#include <array>

#include "bench/accuracy/error_stats.h"
#include "bench/accuracy/tracer.h"
#include "bench/hard_cases/hard_case.h"
#include "core/oracle/oracle.h"

namespace etalon::accuracy {

/// Tracer and what it promises.
struct TracerEntry {
    std::unique_ptr<Tracer> tracer;
    bool exact = false;    ///< to be right, to the same bits as every other that promises it
    bool refined = false;  ///< positions are moved onto the surface, as the renderer does it
};

/// A number of far more digits than a double has, and what a double lacks to it: quad precision is
/// slow, and a hundred times needed for every ray.
class Remainder {
  public:
    Remainder() = default;
    explicit Remainder(Quad x)
        : high_(static_cast<double>(x)), low_(static_cast<double>(x - high_)) {}

    double distance(double x) const { return std::abs((x - high_) - low_); }

  private:
    double high_ = 0, low_ = 0;
};

/// The oracle's answer to one ray, with what only the comparison needs.
class OracleReference {
  public:
    OracleReference(const hard::CaseSetup& setup, const Oracle& oracle, const Ray& ray);

    void classify(const TracerEntry& entry, const Answer& answer, ErrorStats& stats) const;

  private:
    void classify_distance(const TracerEntry& entry, const Answer& answer, ErrorStats& stats) const;
    bool is_right_primitive(const TracerEntry& entry, const Answer& answer) const;
    HitKey lowest_of_the_nearest() const;

    const hard::CaseSetup& setup_;
    const Ray& ray_;
    OracleAnswer answer_;
    Remainder t_;                        ///< of the oracle's hit
    std::array<Remainder, 3> position_;  ///< of the same
    double sensitivity_ = 0;  ///< what t moves by when every input moves by one unit roundoff
};

/// The rays that leave what the given ones hit, in a random direction to either side, half of them
/// grazing: cosines down to 1e-6. A ray that hits nothing leaves nothing.
struct Spawned {
    Ray ray;
    HitKey from;   ///< primitive
    bool outward;  ///< to the front
    double shift;  ///< distance of its origin from the point of the hit, in sizes
};
std::optional<Spawned> spawn(const hard::CaseSetup& setup, const Ray& ray, const Answer& answer,
                             Random& random);

/// No shape meets a ray from its own front or, if it is flat, its back; a closed one meets a ray
/// from its inside on its way out.
bool is_self_hit(const Scene& scene, const Spawned& spawned, const Answer& answer);

}  // namespace etalon::accuracy
