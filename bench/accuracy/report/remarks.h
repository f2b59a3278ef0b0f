// What a plot of error against cost needs said beside it.
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/error_stats.h"

namespace etalon::accuracy {

/// Returns sentences, of what was measured alone: that some of the `cases` that the shape has are
/// missing or were cut short; and why tracers that are never wrong have large errors all the same.
std::vector<std::string> remarks_on(const std::vector<Row>& rows, const std::string& shape,
                                    std::size_t cases);

}  // namespace etalon::accuracy
