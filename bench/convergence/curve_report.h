#pragma once

#include <nlohmann/json.hpp>

#include "bench/convergence/curve.h"
#include "bench/table/legend.h"

namespace etalon::convergence {

nlohmann::ordered_json json_of(const Curve& curve);

/// Returns a table for people: the points of a curve, its slope, floor and efficiency.
std::string table_of(const Curve& curve);

/// Adds what the names of the table mean.
void explain_curve(table::Legend& legend);

}  // namespace etalon::convergence
