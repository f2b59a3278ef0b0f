// Tracers that take part in a measurement, and their construction.
#pragma once

#include <functional>

#include "bench/speed/figures.h"
#include "bench/speed/plan.h"
#include "core/intersect/intersector.h"

namespace etalon::speed {

/// Every backend there is, and embree-builtin-robust.
std::vector<std::string> tracer_names();
const Backend& find_tracer(const std::string& name);

/// Returns the tracers asked for and the baselines, in the order of tracer_names().
std::vector<std::string> with_baselines(const std::vector<std::string>& asked);

struct Tracer {
    const Backend* backend;
    std::unique_ptr<Intersector> intersector;

    std::string name() const { return std::string(backend->name); }
};

/// Builds each tracer's intersector over and over and keeps the last one. With one thread it is
/// pinned; of more, oneTBB decides where they run. Nothing if it was over before the last repeat.
std::vector<BuildFigures> measure_builds(std::vector<Tracer>& tracers, const Scene& scene,
                                         const Plan& plan, const std::function<bool()>& is_over);

}  // namespace etalon::speed
