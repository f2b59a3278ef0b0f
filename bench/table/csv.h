// Lines of comma-separated values (RFC 4180).
#pragma once

#include <string>
#include <vector>

namespace etalon::table {

/// Returns the fields separated by commas, with the end of a line; those with a comma, a quote or
/// an end of a line are in quotes.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace etalon::table
