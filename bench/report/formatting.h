// Formatting of numbers in the report.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "app/common/units.h"
#include "bench/report/content.h"
#include "bench/statistics/statistics.h"

namespace etalon::bench_report {

/// Returns "1 case", "799 cases".
std::string count_of(std::uint64_t n, const std::string& what);

/// Returns three digits: "0.123", "1.23", "12.3", "123", "1,234".
std::string three_digits(double value);

/// Returns "×1.02 ± 0.03"; without the spread if there is none.
std::string times(const statistics::Estimate& ratio);

/// Returns "1.2 s", "35 s", "12 min", "1 h 5 min".
std::string duration(double seconds);

/// Returns "64 B", "1.2 kB", "31 MB", "15 GB": powers of 1000.
std::string bytes(double count);

/// Returns "3 of 2,174", highlighted.
Cell wrong_of(std::uint64_t wrong, std::uint64_t all);

/// Returns the index of a tracer's colour in the style sheet, the same everywhere in the report.
int colour_of(std::string_view tracer);

}  // namespace etalon::bench_report
