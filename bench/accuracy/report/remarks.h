// Remarks on a plot of error over cost.
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/error_stats.h"

namespace etalon::accuracy {

/// Returns sentences about the measured data only: that some of the shape's `cases` are missing or
/// were cut short, and why exact tracers may have large errors.
std::vector<std::string> remarks_on(const std::vector<Row>& rows, const std::string& shape,
                                    std::size_t cases);

}  // namespace etalon::accuracy
