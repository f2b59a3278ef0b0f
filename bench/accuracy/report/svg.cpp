#include "bench/accuracy/report/svg.h"

#include <fmt/format.h>

namespace etalon::accuracy {
namespace {

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

}  // namespace

/// On white, not on nothing: pages may be dark.
Svg::Svg(double width, double height)
    : text_(fmt::format(
          "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
          "height=\"{1}\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" "
          "font-size=\"12\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
          width, height)) {}

void Svg::text(Place at, Anchor anchor, std::string_view text, std::string_view style) {
    constexpr std::string_view names[] = {"start", "middle", "end"};
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", at.x,
                         at.y, names[static_cast<int>(anchor)], style, escaped(text));
}

void Svg::line(Place from, Place to, std::string_view style) {
    text_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n",
                         from.x, from.y, to.x, to.y, style);
}

void Svg::polyline(const std::vector<Place>& places, std::string_view style) {
    std::string points;
    for (const Place& p : places) points += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
    text_ += fmt::format("<polyline points=\"{}\" {}/>\n", points, style);
}

void Svg::dot(Place at, double radius, std::string_view hint, std::string_view style) {
    text_ +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}><title>{}</title></circle>\n",
                    at.x, at.y, radius, style, escaped(hint));
}

}  // namespace etalon::accuracy
