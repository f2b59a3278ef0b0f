#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "bench/accuracy/error_stats.h"

namespace etalon::accuracy {

/// Returns all results with every bit of every number. A distribution is given by its count,
/// quantiles and maximum; an infinite value is null.
nlohmann::ordered_json json(const std::vector<Row>& rows);

}  // namespace etalon::accuracy
