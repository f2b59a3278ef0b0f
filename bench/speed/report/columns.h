// Lines of cells under a heading of two lines.
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>

#include "bench/accuracy/report/numbers.h"
#include "bench/speed/figures.h"

namespace etalon::speed {

/// Column of a table of `Line`s, aligned to the right.
template <class Line>
struct Column {
    const char *above, *name;
    int width;
    std::string (*cell)(const Line& line);
};

/// Beginning of every line.
inline std::string beginning(const std::string& what, const std::string& tracer) {
    return fmt::format("{:<8}{:<22}", what, tracer);
}

inline std::string without_trailing_blanks(const std::string& text) {
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

template <class Line>
std::string heading(const std::string& what, std::span<const Column<Line>> columns) {
    std::string above = beginning("", ""), below = beginning(what, "");
    for (const Column<Line>& c : columns) {
        above += fmt::format("{:>{}}", c.above, c.width);
        below += fmt::format("{:>{}}", c.name, c.width);
    }
    return without_trailing_blanks(above) + "\n" + below + "\n";
}

template <class Line>
std::string text_of(std::string text, const Line& line, std::span<const Column<Line>> columns) {
    for (const Column<Line>& c : columns) text += fmt::format("{:>{}}", c.cell(line), c.width);
    return without_trailing_blanks(text) + "\n";
}

/// Formats values with aligned decimal points as far as that is informative.
inline std::string figure(double value) {
    return value >= 0.01 || value == 0 ? fmt::format("{:.3f}", value) : accuracy::brief(value);
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
    return fmt::format("{:.3f}", line.runs.ratio.spread);
}

template <class Line, Estimate Runs::*Which>
std::string scaling(const Line& line) {
    return line.runs.threads == 1 ? "-" : figure((line.runs.*Which).median);
}

}  // namespace etalon::speed
