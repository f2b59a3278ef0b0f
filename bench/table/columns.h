// Tables for terminals: rows of cells under a heading of two lines.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bench/table/legend.h"

namespace etalon::table {

/// Number of columns that a table shows: those that fit `line_width`, or all.
enum class Detail { narrow, wide };

/// Column of a table with rows of type `Line`, aligned to the right. A name above that ends in "-"
/// continues in the name below.
template <class Line>
struct Column {
    std::string above, name;
    int width;
    std::function<std::string(const Line& line)> cell;
    std::string meaning{};          ///< for the legend; empty if the name is clear
    Detail shown = Detail::narrow;  ///< narrow: always
};

template <class Line>
using Columns = std::vector<Column<Line>>;

std::string without_trailing_blanks(const std::string& text);

/// Returns the lines of the heading, one if there are no names above; `beginning` is that of the
/// lower one.
template <class Line>
std::string heading(std::string beginning, const Columns<Line>& columns, Detail detail) {
    std::string above(beginning.size(), ' ');
    for (const Column<Line>& c : columns) {
        if (c.shown > detail) continue;
        above += fmt::format("{:>{}}", c.above, c.width);
        beginning += fmt::format("{:>{}}", c.name, c.width);
    }
    above = without_trailing_blanks(above);
    return (above.empty() ? "" : above + "\n") + without_trailing_blanks(beginning) + "\n";
}

template <class Line>
std::string line_of(std::string beginning, const Line& line, const Columns<Line>& columns,
                    Detail detail) {
    for (const Column<Line>& c : columns) {
        if (c.shown <= detail) beginning += fmt::format("{:>{}}", c.cell(line), c.width);
    }
    return without_trailing_blanks(beginning) + "\n";
}

/// Adds the meanings of the names of the columns shown.
template <class Line>
void explain(const Columns<Line>& columns, Detail detail, Legend& legend) {
    for (const Column<Line>& c : columns) {
        if (c.shown <= detail) legend.add(whole_name(c.above, c.name), c.meaning);
    }
}

}  // namespace etalon::table
