#include "bench/accuracy/report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "bench/accuracy/report/axes.h"
#include "bench/accuracy/report/cases.h"
#include "bench/accuracy/report/labels.h"
#include "bench/accuracy/report/numbers.h"

namespace etalon::accuracy {
namespace {

constexpr double margin = 24;
constexpr std::string_view small = "font-size=\"11\" fill=\"#777\"";

/// Keeps text legible on a line.
constexpr std::string_view halo =
    "paint-order=\"stroke\" stroke=\"#fff\" stroke-width=\"3\" stroke-linejoin=\"round\"";

/// Who is alike has a colour.
enum Kind { exact, textbook, other };
constexpr std::string_view colours[] = {"#1a5fa5", "#5c5c5c", "#b5482a"};
constexpr std::string_view kinds[] = {"promises to be right", "textbook kernel", "float backend"};

Kind kind_of(const Point& p) {
    if (p.exact) return exact;
    return is_textbook(p.contender) ? textbook : other;
}

void draw_titles(Svg& svg, std::string shape, const Scatter& scatter) {
    shape[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(shape[0])));
    svg.text({margin, 34}, Anchor::start, shape,
             "font-size=\"18\" font-weight=\"bold\" fill=\"#222\"");
    svg.text({margin, 55}, Anchor::start,
             fmt::format("Error against cost over {} hard case{}. Filled: the Pareto set, which "
                         "nothing beats in both.",
                         scatter.cases, scatter.cases == 1 ? "" : "s"),
             "fill=\"#555\"");
    svg.text({margin, Axes::top - 32}, Anchor::start,
             "error of the worst case: t in ulp of float, plus wrong answers per 10⁶ rays", small);
    const std::string unit =
        scatter.unit.empty() ? "in nanoseconds" : "relative to " + scatter.unit;
    svg.text({Axes::right, Axes::bottom + 54}, Anchor::end, "median cost of a ray, " + unit, small);
}

/// The kinds that are there, in a row below the axis.
void draw_key(Svg& svg, const Scatter& scatter) {
    double x = margin;
    for (const Kind kind : {exact, textbook, other}) {
        const bool is_there = std::any_of(scatter.points.begin(), scatter.points.end(),
                                          [&](const Point& p) { return kind_of(p) == kind; });
        if (!is_there) continue;
        svg.text({x, Axes::bottom + 54}, Anchor::start, kinds[kind],
                 fmt::format("font-size=\"11\" fill=\"{}\"", colours[kind]));
        x += 6.2 * static_cast<double>(kinds[kind].size()) + 16;
    }
}

void draw_ticks(Svg& svg, const Axes& axes) {
    for (const Tick& tick : axes.error_ticks()) {
        const double y = axes.place(1, tick.value).y;
        svg.line({Axes::left, y}, {Axes::right, y}, "stroke=\"#f0f0f0\"");
        svg.text({Axes::left - 8, y + 4}, Anchor::end, tick.text, small);
    }
    const double y = Axes::bottom + 12;
    for (const Tick& tick : axes.cost_ticks()) {
        const double x = axes.place(tick.value, 0).x;
        svg.line({x, y}, {x, y + 4}, "stroke=\"#999\"");
        svg.text({x, y + 18}, Anchor::middle, tick.text, small);
    }
}

/// The edge of what is dominated: level from each point to the cost at which there is a better one.
std::vector<Place> frontier(const Scatter& scatter, const Axes& axes) {
    std::vector<Place> corners;
    for (const Point& p : scatter.points) {
        if (!p.efficient) continue;
        const Place here = axes.place(p.cost, p.error);
        if (!corners.empty()) corners.push_back({here.x, corners.back().y});
        corners.push_back(here);
    }
    return corners;
}

/// Places so close along the frontier that no label fits between.
std::vector<Place> along(const std::vector<Place>& corners) {
    std::vector<Place> places;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        constexpr int steps = 40;
        for (int k = 0; k <= steps; ++k) {
            const double s = static_cast<double>(k) / steps;
            const Place &a = corners[i - 1], &b = corners[i];
            places.push_back({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)});
        }
    }
    return places;
}

void draw_points(Svg& svg, const Scatter& scatter, const Axes& axes) {
    for (const Point& p : scatter.points) {
        const std::string_view c = colours[kind_of(p)];
        const std::string hint = fmt::format("{}: cost {}, error {} in {}", p.contender,
                                             brief(p.cost), brief(p.error), p.worst_case);
        svg.dot(axes.place(p.cost, p.error), 4.5, hint,
                fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.5\"",
                            p.efficient ? c : "#fff", c));
    }
}

void draw_labels(Svg& svg, const Scatter& scatter, const Axes& axes,
                 const std::vector<Place>& avoid) {
    std::vector<Label> labels;
    for (const Point& p : scatter.points) {
        labels.push_back({p.contender, p.efficient, axes.place(p.cost, p.error)});
    }
    place(labels, {Axes::left, Axes::top - 26, Axes::width - 4, Axes::bottom + 10}, avoid);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const Label& label = labels[i];
        if (label.is_far) svg.line(label.mark, leader_end(label), "stroke=\"#bbb\"");
        svg.text(label.at, label.anchor, label.text,
                 fmt::format("{} fill=\"{}\"{}", halo, colours[kind_of(scatter.points[i])],
                             label.is_bold ? " font-weight=\"bold\"" : ""));
    }
}

}  // namespace

std::string plot(const std::vector<Row>& rows, const std::string& shape) {
    const Scatter scatter = scatter_of(rows, shape);
    if (scatter.points.empty()) return {};
    const Axes axes(scatter);
    const std::vector<Place> corners = frontier(scatter, axes);
    Svg svg(Axes::width, Axes::height);
    draw_titles(svg, shape, scatter);
    draw_key(svg, scatter);
    draw_ticks(svg, axes);
    svg.polyline(corners, "fill=\"none\" stroke=\"#b9c6d6\" stroke-width=\"1.5\"");
    draw_labels(svg, scatter, axes, along(corners));
    draw_points(svg, scatter, axes);
    return svg.finished();
}

}  // namespace etalon::accuracy
