// Formatting of numbers in reports: few digits, never wider than a column.
#pragma once

#include <cstdint>
#include <string>

namespace etalon::accuracy {

/// Formats a value with two or three digits, or with one digit below 1e-9, in at most six
/// characters: "0", "0.25", "12.3", "9087", "4.6e4", "6e-17".
std::string brief(double value);

/// Returns a count: exact up to six digits, then like "2.5e6".
std::string brief_count(std::uint64_t count);

}  // namespace etalon::accuracy
