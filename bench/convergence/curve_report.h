#pragma once

#include <nlohmann/json.hpp>

#include "bench/convergence/curve.h"

namespace etalon::convergence {

nlohmann::ordered_json json_of(const Curve& curve);

/// Returns a table for people: the points of a curve, its slope, floor and efficiency.
std::string table_of(const Curve& curve);

/// Returns what the names of the table mean.
std::string legend();

}  // namespace etalon::convergence
