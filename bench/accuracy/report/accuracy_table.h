#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/error_stats.h"

namespace etalon::accuracy {

/// The rows as a table for the terminal, some 160 columns wide, by shape and case. A "." is a zero,
/// so that errors stand out; a "-" is what the case's criterion does not look at. The shape that
/// already has its heading gets none.
std::string table(const std::vector<Row>& rows, const std::string& heading_above = {});

}  // namespace etalon::accuracy
