#pragma once

#include <nlohmann/json.hpp>

#include "bench/convergence/curve.h"

namespace etalon::convergence {

nlohmann::ordered_json json_of(const Curve& curve);

/// Returns a table for people: the points of a curve, its slope, floor and efficiency.
std::string table(const Curve& curve);

}  // namespace etalon::convergence
