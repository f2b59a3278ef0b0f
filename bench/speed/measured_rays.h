// Speed and errors of the tracers' answers to rays.
#pragma once

#include <functional>
#include <optional>

#include "bench/speed/speed_config.h"
#include "bench/speed/timed_tracer.h"

namespace etalon::speed {

class RayMeasurement {
  public:
    /// The setup, of which only the scene, its size and the tie are used, and the tracers, which
    /// must be built, must outlive this.
    RayMeasurement(const hard::CaseSetup& setup, const std::vector<TimedTracer>& tracers,
                   const SpeedConfig& config);

    /// Returns the backend that decides where rays start.
    const Intersector& exact() const { return *tracer_named(default_backend).intersector; }

    /// Measures a set of rays, with fewer repeats and checked rays when it is over; nothing if it
    /// was over before the first repeat was complete.
    std::optional<KindFigures> measure(const RaySet& set,
                                       const std::function<bool()>& is_over) const;

  private:
    using Answers = std::vector<std::vector<Answer>>;  ///< for each tracer

    const TimedTracer& tracer_named(const std::string& name) const;
    std::vector<RayFigures> time(const RaySet& set, const std::function<bool()>& is_over,
                                 Answers& answers) const;
    std::vector<Answer> answers_of(const std::string& name, const RaySet& set,
                                   const Answers& answers) const;
    static std::vector<std::size_t> disputed_rays(const RaySet& set, const Answers& answers);
    OracleReferences oracle_references(const RaySet& set, const std::vector<std::size_t>& places,
                                       const std::function<bool()>& is_over) const;
    void find_errors(const RaySet& set, const Answers& answers,
                     const std::function<bool()>& is_over, KindFigures& figures) const;

    const hard::CaseSetup& setup_;
    const std::vector<TimedTracer>& tracers_;
    const SpeedConfig config_;
    const Oracle oracle_;
    std::vector<TimedTracer> references_;  ///< others are compared with them; they are not measured
};

}  // namespace etalon::speed
