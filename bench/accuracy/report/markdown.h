#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/error_stats.h"

namespace etalon::accuracy {

/// The rows in short, as docs/accuracy.md has them: a heading and a table for each shape, a line
/// for each case. The backends that promise to be right share a column, as they give the same bits.
std::string markdown(const std::vector<Row>& rows);

}  // namespace etalon::accuracy
