// Cells, and meanings of columns, that the tables of speed share.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>

#include "bench/accuracy/report/numbers.h"
#include "bench/speed/figures.h"
#include "bench/table/columns.h"

namespace etalon::speed {

/// Beginning of every line.
inline std::string beginning(const std::string& what, const std::string& tracer) {
    return fmt::format("{:<7}{:<22}", what, tracer);
}

/// Formats values with aligned decimal points as far as that is informative.
inline std::string figure(double value) {
    return value >= 0.01 || value == 0 ? fmt::format("{:.3f}", value) : accuracy::brief(value);
}

inline std::string count(std::uint64_t n) {
    return n == 0 ? "." : accuracy::brief_count(n);
}

/// The cells that every line with `runs` has.
template <class Line>
std::string threads(const Line& line) {
    return fmt::format("{}", line.runs.threads);
}

template <class Line, Estimate Runs::*Which>
std::string ratio(const Line& line) {
    return figure((line.runs.*Which).median);
}

template <class Line>
std::string spread(const Line& line) {
    const std::optional<double> value = line.runs.ratio.spread;
    if (!value) return "-";
    return *value < 9.9995 ? fmt::format("{:.3f}", *value) : accuracy::brief(*value);
}

template <class Line, Estimate Runs::*Which>
std::string scaling(const Line& line) {
    return line.runs.threads == 1 ? "-" : figure((line.runs.*Which).median);
}

namespace meaning {

inline constexpr const char* builtin = "times as fast as embree-builtin, in CPU time";
inline constexpr const char* robust = "times as fast as embree-builtin-robust, in CPU time";
inline constexpr const char* spread = "how far apart the middle half of the repeats' ratios is";
inline constexpr const char* nothing = "does not apply, or is not known from one repeat";
inline constexpr const char* cpu_scaling = "CPU seconds on one thread over those on all of these";
inline constexpr const char* wall_scaling = "seconds on one thread over seconds on these";
inline constexpr const char* sampled = "rays, spread evenly over all, that the oracle checked";
inline constexpr const char* wrong_of_sampled = "wrong answers among these";
inline constexpr const char* disputed =
    "rays about which not all backends agree, and which the oracle checked too";
inline constexpr const char* wrong_of_disputed = "wrong answers among those";

}  // namespace meaning

}  // namespace etalon::speed
