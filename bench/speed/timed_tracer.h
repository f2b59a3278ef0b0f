// Tracers of a measurement, and their construction.
#pragma once

#include <functional>

#include "bench/speed/figures.h"
#include "bench/speed/speed_config.h"
#include "core/intersect/intersector.h"

namespace etalon::speed {

/// Returns the names of all backends, and embree-builtin-robust.
std::vector<std::string> tracer_names();
const Backend& find_tracer(const std::string& name);

/// Returns the requested tracers and the baselines, in the order of tracer_names().
std::vector<std::string> with_baselines(const std::vector<std::string>& requested);

struct TimedTracer {
    const Backend* backend;
    std::unique_ptr<Intersector> intersector;

    std::string name() const { return std::string(backend->name); }
};

/// Builds each tracer's intersector repeatedly and keeps the last one. A single thread is pinned;
/// for more, oneTBB decides where they run. When it is over there are fewer repeats; returns
/// nothing without any.
std::vector<BuildFigures> measure_builds(std::vector<TimedTracer>& tracers, const Scene& scene,
                                         const SpeedConfig& config,
                                         const std::function<bool()>& is_over);

}  // namespace etalon::speed
