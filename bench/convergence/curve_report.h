#pragma once

#include <nlohmann/json.hpp>

#include "bench/convergence/curve.h"
#include "bench/table/legend.h"

namespace etalon::convergence {

nlohmann::ordered_json json_of(const Curve& curve);

/// Returns a table for the terminal: the points of a curve, its slope, floor and efficiency.
std::string table_of(const Curve& curve);

/// Adds the meanings of the table's column names.
void explain_curve(table::Legend& legend);

}  // namespace etalon::convergence
