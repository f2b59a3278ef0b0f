#include <fmt/format.h>

#include "bench/plot/svg.h"
#include "bench/report/html/html.h"

namespace etalon::bench_report {
namespace {

using plot::escaped;

/// Keeps names on one line; sentences may wrap.
bool is_name(const std::string& text) {
    constexpr std::size_t longest = 24;
    return text.size() <= longest;
}

std::string classes_of(const Cell& cell, const Column& column) {
    std::string classes = column.is_number ? "number" : is_name(cell.text) ? "name" : "";
    if (cell.mark == Mark::good) classes += " good";
    if (cell.mark == Mark::bad) classes += " bad";
    return classes.empty() ? "" : fmt::format(" class=\"{}\"", classes);
}

std::string head(const Table& table) {
    std::string cells;
    bool has_names = false;
    for (const Column& c : table.columns) {
        cells += fmt::format("<th scope=\"col\"{}>{}</th>", c.is_number ? " class=\"number\"" : "",
                             escaped(c.name));
        has_names |= !c.name.empty();
    }
    return has_names ? "<thead><tr>" + cells + "</tr></thead>\n" : "";
}

std::string row(const Table& table, const std::vector<Cell>& cells) {
    std::string text = "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string_view tag = i == 0 ? "th scope=\"row\"" : "td";
        text += fmt::format("<{}{}>{}</{}>", tag, classes_of(cells[i], table.columns.at(i)),
                            escaped(cells[i].text), tag.substr(0, 2));
    }
    return text + "</tr>\n";
}

}  // namespace

std::string html(const Table& table) {
    std::string text = "<div class=\"scroll\" tabindex=\"0\"><table>\n" + head(table) + "<tbody>\n";
    for (const std::vector<Cell>& cells : table.rows) text += row(table, cells);
    return text + "</tbody></table></div>\n";
}

}  // namespace etalon::bench_report
