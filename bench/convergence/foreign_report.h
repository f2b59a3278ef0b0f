// Reports on other programs' curves, compared with ours.
#pragma once

#include <nlohmann/json.hpp>

#include "bench/convergence/equal_error.h"
#include "bench/table/legend.h"

namespace etalon::convergence {

nlohmann::ordered_json json_of(const ForeignCurve& curve);
nlohmann::ordered_json json_of(const CurveComparison& comparison);

/// Returns a table for the terminal: the images of another program.
std::string table_of(const ForeignCurve& curve);

/// Returns a table for the terminal: CPU time to equal error.
std::string table_of(const CurveComparison& comparison);

/// Adds the meanings of these tables' column names.
void explain_foreign(table::Legend& legend);

/// Returns all points of all curves as CSV, with a heading: ours, then those of other programs, one
/// line for each curve with which they are compared.
std::string csv_of(const std::vector<Curve>& own, const std::vector<ForeignCurve>& foreign,
                   const std::vector<CurveComparison>& comparisons);

}  // namespace etalon::convergence
