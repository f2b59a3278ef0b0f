// The figures as JSON, with the seconds of every repeat.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "bench/speed/figures.h"
#include "bench/speed/plan.h"

namespace etalon::speed {

/// Returns the machine, compiler and versions of the measurement.
nlohmann::ordered_json json_of_machine();

/// The same and the plan. The scenes are for the caller to add.
nlohmann::ordered_json json_of_environment(const Plan& plan);

nlohmann::ordered_json json_of(const SceneFigures& scene);

}  // namespace etalon::speed
