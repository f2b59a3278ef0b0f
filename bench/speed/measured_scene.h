#pragma once

#include <functional>

#include "bench/speed/figures.h"
#include "bench/speed/plan.h"
#include "core/scene/scene.h"

namespace etalon::speed {

/// Function called with the results so far, after the builds and after each kind of ray; it returns
/// false to stop there.
using Observer = std::function<bool(const SceneFigures& figures)>;

/// Builds every tracer of the plan and gives it rays of every kind that the scene has, for a
/// image of this resolution.
SceneFigures measure_scene(const std::string& name, Scene scene, const Imath::V2i& resolution,
                           const Plan& plan, const Observer& observer);

}  // namespace etalon::speed
