// Bars as rows of a table: their names and numbers are text of the page's own size, on a phone too,
// and only the lengths are SVG, which is stretched to whatever room there is, and printed.
#include <fmt/format.h>

#include <algorithm>

#include "bench/plot/svg.h"
#include "bench/report/html/html.h"

namespace etalon::bench_report {
namespace {

using plot::escaped;

constexpr double length = 1000;  ///< of the longest bar, in the SVG's units

double longest(const BarGroup& group) {
    double most = group.reference;
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

std::string reference_of(double at) {
    if (at <= 0) return "";
    return fmt::format(
        "<line class=\"reference\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"0\" y2=\"12\"/>", at);
}

std::string rod(const Bar& bar, const BarGroup& group) {
    const double scale = length / longest(group);
    return fmt::format(
        "<svg class=\"rod\" viewBox=\"0 0 1000 12\" preserveAspectRatio=\"none\" "
        "aria-hidden=\"true\"><rect class=\"b{}\" width=\"{:.1f}\" height=\"12\"/>{}{}</svg>",
        bar.colour, scale * bar.value, spread_of(bar, scale),
        reference_of(scale * group.reference));
}

std::string note_of(const Cell& note) {
    const char* mark = note.mark == Mark::good ? " good" : note.mark == Mark::bad ? " bad" : "";
    return fmt::format("<td class=\"note{}\">{}</td>", mark, escaped(note.text));
}

std::string row(const Bar& bar, const BarGroup& group) {
    return fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"length\">{}</td><td class=\"value\">{}</td>"
        "<td class=\"ratio\">{}</td>{}</tr>\n",
        escaped(bar.name), rod(bar, group), escaped(bar.text), escaped(bar.comparison),
        note_of(bar.note));
}

}  // namespace

std::string html(const Bars& bars) {
    std::string text = "<div class=\"groups\">\n";
    for (const BarGroup& group : bars.groups) {
        text += fmt::format("<div class=\"group\"><table class=\"bars\"><caption>{}</caption>\n",
                            escaped(group.title));
        for (const Bar& bar : group.bars) text += row(bar, group);
        text += "</table></div>\n";
    }
    return text + "</div>\n";
}

}  // namespace etalon::bench_report
