// The figures as JSON, with the seconds of every repeat.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "bench/speed/figures.h"
#include "bench/speed/speed_config.h"

namespace etalon::speed {

/// Returns the provenance and the config of a measurement. The scenes are for the caller to add.
nlohmann::ordered_json json_of_environment(const SpeedConfig& config);

nlohmann::ordered_json json_of(const SceneFigures& scene);

}  // namespace etalon::speed
