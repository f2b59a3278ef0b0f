// Bar charts as tables: names and numbers are ordinary text, also on small screens, and only the
// bars are SVG, which is stretched to the available width and can be printed.
#include <fmt/format.h>

#include <algorithm>

#include "bench/plot/svg.h"
#include "bench/report/html/html.h"

namespace etalon::bench_report {
namespace {

using plot::escaped;

constexpr double length = 1000;  ///< length of the longest bar, in units of the SVG

double longest(const BarGroup& group) {
    double most = 0;
    for (const Bar& bar : group.bars) most = std::max(most, bar.value + bar.spread / 2);
    return most > 0 ? most : 1;
}

std::string spread_of(const Bar& bar, double scale) {
    if (bar.spread <= 0) return "";
    const double from = std::max(0.0, bar.value - bar.spread / 2);
    return fmt::format(
        "<rect class=\"spread\" x=\"{:.1f}\" y=\"5\" width=\"{:.1f}\" height=\"2\"/>", scale * from,
        scale * (bar.value + bar.spread / 2 - from));
}

std::string rod(const Bar& bar, double scale) {
    return fmt::format(
        "<svg class=\"rod\" viewBox=\"0 0 1000 12\" preserveAspectRatio=\"none\" "
        "aria-hidden=\"true\"><rect class=\"b{}\" width=\"{:.1f}\" height=\"12\"/>{}</svg>",
        bar.colour, scale * bar.value, spread_of(bar, scale));
}

/// The name is in the column's header, and also in the cell, for screens too narrow for columns.
std::string cell(const char* classes, const std::string& name, const std::string& text) {
    return fmt::format("<td class=\"{}\" data-name=\"{}\">{}</td>", classes, escaped(name),
                       escaped(text));
}

std::string note_of(const Cell& note, const std::string& name) {
    const char* mark = note.mark == Mark::good  ? "note good"
                       : note.mark == Mark::bad ? "note bad"
                                                : "note";
    return cell(mark, name, note.text);
}

std::string head(const BarGroup& group) {
    return fmt::format(
        "<thead><tr><th scope=\"col\" class=\"name\">{}</th><td class=\"length\"></td>"
        "<th scope=\"col\" class=\"value\">{}</th><th scope=\"col\" class=\"ratio\">{}</th>"
        "<th scope=\"col\" class=\"note\">{}</th></tr></thead>\n",
        escaped(group.title), escaped(group.value), escaped(group.comparison), escaped(group.note));
}

std::string row(const Bar& bar, const BarGroup& group) {
    return fmt::format(
        "<tr><th scope=\"row\" class=\"name\">{}</th><td class=\"length\">{}</td>"
        "{}{}{}</tr>\n",
        escaped(bar.name), rod(bar, length / longest(group)), cell("value", group.value, bar.text),
        cell("ratio", group.comparison, bar.comparison), note_of(bar.note, group.note));
}

}  // namespace

std::string html(const Bars& bars) {
    std::string text = "<div class=\"groups\">\n";
    for (const BarGroup& group : bars.groups) {
        text += "<div class=\"group\"><table class=\"bars\">\n" + head(group) + "<tbody>\n";
        for (const Bar& bar : group.bars) text += row(bar, group);
        text += "</tbody></table></div>\n";
    }
    return text + "</div>\n";
}

}  // namespace etalon::bench_report
