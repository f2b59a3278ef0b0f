#include <fmt/format.h>

#include <algorithm>

#include "bench/plot/style.h"
#include "bench/plot/svg.h"
#include "bench/report/html/html.h"

namespace etalon::bench_report {
namespace {

using plot::escaped;

/// The content security policy makes browsers refuse resources of other origins.
std::string head(const Page& page) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
        "style-src 'unsafe-inline'; img-src data:\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n"
        "<link rel=\"icon\" href=\"data:,\">\n<title>{}</title>\n<style>{}{}</style>\n</head>\n",
        escaped(page.title), style_sheet(), plot::style());
}

std::string summary(const Page& page) {
    if (page.summary.empty()) return "";
    std::string text = "<div class=\"facts\">\n";
    for (const KeyFigure& figure : page.summary) {
        text += fmt::format("<div class=\"fact\"><b>{}</b><span>{}</span><small>{}</small></div>\n",
                            escaped(figure.value), escaped(figure.name), escaped(figure.note));
    }
    return text + "</div>\n";
}

std::string contents(const Page& page) {
    std::string text = "<nav aria-label=\"Contents\"><ul>\n";
    for (const Section& s : page.sections) {
        text += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", s.id, escaped(s.title));
    }
    return text + "</ul></nav>\n";
}

std::string header(const Page& page) {
    std::string text = fmt::format("<header>\n<h1>{}</h1>\n<p class=\"quiet\">{}</p>\n",
                                   escaped(page.title), escaped(page.subtitle));
    if (!page.missing.empty()) {
        text += fmt::format("<p class=\"missing\" role=\"status\"><b>Not complete.</b> {}</p>\n",
                            escaped(page.missing));
    }
    if (!page.warning.empty()) {
        text += fmt::format("<p class=\"missing\" role=\"status\"><b>Doubtful.</b> {}</p>\n",
                            escaped(page.warning));
    }
    text += fmt::format("<p>{}</p>\n", escaped(page.introduction));
    return text + summary(page) + contents(page) + "</header>\n";
}

/// Breaks a line only between words, except for words longer than a line.
std::string words_of(const std::string& command) {
    std::string text;
    for (std::size_t at = 0; at < command.size();) {
        const std::size_t end = std::min(command.find(' ', at), command.size());
        text += "<span>" + escaped(command.substr(at, end - at)) + "</span> ";
        at = end + 1;
    }
    return text;
}

std::string figure(const Figure& f) {
    const std::string content = std::visit([](const auto& c) { return html(c); }, f.content);
    const std::string caption = fmt::format(
        "<figcaption><p>{}</p><p class=\"source\"><time>{}</time> <code>{}</code></p></figcaption>",
        escaped(f.caption), escaped(f.date), words_of(f.command));
    constexpr const char* open = "<figure><h3>{}</h3>\n{}{}</figure>\n";
    constexpr const char* folded =
        "<figure class=\"folded\"><details><summary>{}</summary>\n{}{}</details></figure>\n";
    return fmt::format(fmt::runtime(f.folded ? folded : open), escaped(f.title), content, caption);
}

std::string section(const Section& s) {
    std::string text = fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n", s.id, escaped(s.title));
    for (const std::string& p : s.prose) text += "<p>" + escaped(p) + "</p>\n";
    if (s.figures.empty()) text += "<p class=\"missing\">Not measured.</p>\n";
    for (const Figure& f : s.figures) text += figure(f);
    return text + "</section>\n";
}

}  // namespace

std::string html(const Page& page) {
    std::string text = head(page) + "<body>\n" + header(page) + "<main>\n";
    for (const Section& s : page.sections) text += section(s);
    return text + fmt::format(
                      "</main>\n<footer><p>Made by <code>{}</code></p></footer>\n"
                      "</body>\n</html>\n",
                      escaped(page.command));
}

}  // namespace etalon::bench_report
