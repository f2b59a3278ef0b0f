#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/error_stats.h"
#include "bench/table/columns.h"

namespace etalon::accuracy {

/// Returns the rows as a table for the terminal, by shape and case. A "." is a zero, so that errors
/// stand out; a "-" is a value that the case's criterion does not include. The shape whose heading
/// has been printed already gets none.
std::string table_of(const std::vector<Row>& rows, table::Detail detail,
                     const std::string& heading_above = {});

/// Returns what the columns of the table mean.
std::string legend(table::Detail detail);

}  // namespace etalon::accuracy
