#include "bench/plot/svg.h"

#include <fmt/format.h>

#include "bench/plot/style.h"

namespace etalon::plot {
namespace {

std::string list_of(const std::vector<Position>& positions) {
    std::string list;
    for (const Position& p : positions) {
        list += fmt::format("{}{:.1f},{:.1f}", list.empty() ? "" : " ", p.x, p.y);
    }
    return list;
}

/// Returns a style sheet with the default of each variable in its place.
std::string without_variables(std::string_view css) {
    constexpr std::string_view variable = "var(";
    std::string text;
    for (;;) {
        const std::size_t begin = css.find(variable);
        text += css.substr(0, begin);
        if (begin == std::string_view::npos) return text;
        css.remove_prefix(css.find(',', begin) + 1);
        const std::size_t end = css.find(')');
        text += css.substr(0, end);
        css.remove_prefix(end + 1);
    }
}

}  // namespace

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
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

Svg::Svg(double width, double height, std::string_view title, std::string_view description)
    : width_(width),
      height_(height),
      text_(fmt::format("<title>{}</title>\n<desc>{}</desc>\n", escaped(title),
                        escaped(description))) {}

void Svg::text(Position at, Anchor anchor, std::string_view text, std::string_view classes) {
    constexpr std::string_view names[] = {"start", "middle", "end"};
    text_ +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" class=\"{}\">{}</text>\n",
                    at.x, at.y, names[static_cast<int>(anchor)], classes, escaped(text));
}

void Svg::line(Position from, Position to, std::string_view classes) {
    text_ += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" class=\"{}\"/>\n", from.x,
        from.y, to.x, to.y, classes);
}

void Svg::polyline(const std::vector<Position>& positions, std::string_view classes) {
    text_ += fmt::format("<polyline points=\"{}\" class=\"{}\"/>\n", list_of(positions), classes);
}

void Svg::polygon(const std::vector<Position>& positions, std::string_view classes) {
    text_ += fmt::format("<polygon points=\"{}\" class=\"{}\"/>\n", list_of(positions), classes);
}

void Svg::dot(Position at, double radius, std::string_view hint, std::string_view classes) {
    text_ += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" class=\"{}\"><title>{}</title></circle>\n",
        at.x, at.y, radius, classes, escaped(hint));
}

std::string Svg::document(std::string_view attributes, std::string_view beginning) const {
    return fmt::format(
        "<svg class=\"chart\" role=\"img\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\"{2}>\n{3}{4}</svg>\n",
        width_, height_, attributes, beginning, text_);
}

std::string Svg::inlined() const {
    return document("", "");
}

std::string Svg::standalone() const {
    return document(" xmlns=\"http://www.w3.org/2000/svg\"",
                    fmt::format("<style>{}</style>\n<rect width=\"{}\" height=\"{}\" "
                                "class=\"paper\"/>\n",
                                without_variables(style()), width_, height_));
}

}  // namespace etalon::plot
