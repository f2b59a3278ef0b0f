#pragma once

#include <functional>

#include "bench/speed/figures.h"
#include "bench/speed/speed_config.h"
#include "core/scene/scene.h"

namespace etalon::speed {

struct Observer {
    /// Called with the results so far, after the builds and after each kind of ray.
    std::function<void(const SceneFigures& figures)> show;
    std::function<bool()> is_over;  ///< called often; true: leave out repeats that are not finished
};

/// Builds every tracer of the config and traces rays of every kind that the scene has, for an image
/// of this resolution. When it is over, the builds or rays being measured have fewer repeats, and
/// what has none is left out.
SceneFigures measure_scene(const std::string& name, Scene scene, const Imath::V2i& resolution,
                           const SpeedConfig& config, const Observer& observer);

}  // namespace etalon::speed
