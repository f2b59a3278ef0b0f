#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/tally.h"

namespace etalon::accuracy {

/// Error against cost of all that took part in a shape's cases, as an SVG picture; empty if nobody
/// has a cost.
std::string plot(const std::vector<Row>& rows, const std::string& shape);

}  // namespace etalon::accuracy
