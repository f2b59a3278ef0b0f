#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/error_stats.h"

namespace etalon::accuracy {

/// Returns a summary of the rows for docs/accuracy.md: a heading and a table for each shape, a line
/// for each case. The exact backends share a column, as they give the same bits.
std::string markdown(const std::vector<Row>& rows);

}  // namespace etalon::accuracy
