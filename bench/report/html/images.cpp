#include <fmt/format.h>

#include "bench/plot/svg.h"
#include "bench/report/html/html.h"

namespace etalon::bench_report {
namespace {

using plot::escaped;

std::string html(const KeyEntry& entry) {
    return fmt::format(
        "<li><svg class=\"swatch\" viewBox=\"0 0 12 12\" aria-hidden=\"true\"><circle "
        "class=\"b{}\" "
        "cx=\"6\" cy=\"6\" r=\"5\"/></svg>{}</li>",
        entry.colour, escaped(entry.text));
}

}  // namespace

std::string html(const Charts& charts) {
    std::string text;
    if (!charts.key.empty()) {
        text += "<ul class=\"key\">";
        for (const KeyEntry& entry : charts.key) text += html(entry);
        text += "</ul>\n";
    }
    text += "<div class=\"charts\">\n";
    for (const Chart& chart : charts.charts) {
        text += fmt::format("<div class=\"plot\"><h4>{}</h4>\n{}", escaped(chart.title), chart.svg);
        for (const std::string& remark : chart.remarks) {
            text += fmt::format("<p class=\"remark\">{}</p>\n", escaped(remark));
        }
        text += "</div>\n";
    }
    return text + "</div>\n";
}

std::string html(const Images& images) {
    std::string text = "<div class=\"images\">\n";
    for (const Image& image : images.images) {
        text += fmt::format(
            "<div class=\"image\"><img alt=\"{0}\" width=\"{1}\" height=\"{2}\" "
            "src=\"data:image/png;base64,{3}\"><p>{0}</p></div>\n",
            escaped(image.title), image.width, image.height, base64(image.png));
    }
    return text + "</div>\n";
}

}  // namespace etalon::bench_report
