#include "bench/accuracy/report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "bench/accuracy/report/axes.h"
#include "bench/accuracy/report/cases.h"
#include "bench/accuracy/report/numbers.h"
#include "bench/plot/labels.h"

namespace etalon::accuracy {
namespace {

using plot::Anchor;
using plot::Label;
using plot::PlotArea;
using plot::Position;
using plot::Svg;
using plot::Tick;

constexpr double margin = 24;
constexpr double line_height = 16;
constexpr std::size_t line_width = 118;  ///< in characters, of small text
constexpr PlotArea large{760, 500, 72, 728, 120, 426};
constexpr PlotArea small{360, 280, 34, 348, 30, 228};

/// Kind of a tracer; each kind has a colour.
enum Kind { exact, textbook, other };
constexpr std::string_view colours[] = {"c1", "c7", "c2"};
constexpr std::string_view kinds[] = {"promises to be right", "textbook kernel", "float backend"};

constexpr std::string_view error_axis =
    "error of the worst case: t in ulp of float, plus wrong answers per 10⁶ rays";

Kind kind_of(const Point& p) {
    if (p.exact) return exact;
    return is_textbook(p.tracer) ? textbook : other;
}

std::string cost_axis(const Scatter& scatter) {
    return "median cost of a ray, " +
           (scatter.unit.empty() ? "in nanoseconds" : "relative to " + scatter.unit);
}

void draw_titles(Svg& svg, std::string shape, const Scatter& scatter) {
    shape[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(shape[0])));
    svg.text({margin, 34}, Anchor::start, shape, "heading");
    svg.text({margin, 55}, Anchor::start,
             fmt::format("Error against cost over {} hard case{}. Filled: the Pareto set, which "
                         "nothing beats in both.",
                         scatter.cases, scatter.cases == 1 ? "" : "s"),
             "");
    svg.text({margin, large.top - 32}, Anchor::start, error_axis, "small");
    svg.text({large.right, large.bottom + 54}, Anchor::end, cost_axis(scatter), "small");
}

/// Draws the kinds of tracers that occur, in a row below the axis.
void draw_key(Svg& svg, const Scatter& scatter) {
    double x = margin;
    for (const Kind kind : {exact, textbook, other}) {
        const bool is_there = std::any_of(scatter.points.begin(), scatter.points.end(),
                                          [&](const Point& p) { return kind_of(p) == kind; });
        if (!is_there) continue;
        svg.text({x, large.bottom + 54}, Anchor::start, kinds[kind],
                 fmt::format("small name {}", colours[kind]));
        x += 6.2 * static_cast<double>(kinds[kind].size()) + 16;
    }
}

/// Returns the lines of the remarks, each on a new line, wrapped at words.
std::vector<std::string> lines_of(const std::vector<std::string>& remarks) {
    std::vector<std::string> lines;
    for (const std::string& remark : remarks) {
        lines.emplace_back();
        std::istringstream words(remark);
        for (std::string word; words >> word;) {
            if (lines.back().size() + 1 + word.size() > line_width) lines.emplace_back();
            lines.back() += (lines.back().empty() ? "" : " ") + word;
        }
    }
    return lines;
}

void draw_ticks(Svg& svg, const Axes& axes) {
    const PlotArea& plot_area = axes.plot_area();
    double below = plot_area.bottom + 12;
    for (const Tick& tick : axes.error_ticks()) {
        const double y = axes.position(1, tick.value).y;
        if (below - y < 12) continue;  // the two labels would touch
        below = y;
        svg.line({plot_area.left, y}, {plot_area.right, y}, "grid");
        svg.text({plot_area.left - 8, y + 4}, Anchor::end, tick.text, "small");
    }
    const double y = plot_area.bottom + 12;
    for (const Tick& tick : axes.cost_ticks()) {
        const double x = axes.position(tick.value, 0).x;
        svg.line({x, y}, {x, y + 4}, "tick");
        svg.text({x, y + 18}, Anchor::middle, tick.text, "small");
    }
}

/// Returns the Pareto frontier: horizontal from each point to the cost at which there is a better
/// one.
std::vector<Position> frontier(const Scatter& scatter, const Axes& axes) {
    std::vector<Position> corners;
    for (const Point& p : scatter.points) {
        if (!p.efficient) continue;
        const Position here = axes.position(p.cost, p.error);
        if (!corners.empty()) corners.push_back({here.x, corners.back().y});
        corners.push_back(here);
    }
    return corners;
}

/// Returns points along the frontier that are so close together that no label fits between them.
std::vector<Position> along(const std::vector<Position>& corners) {
    std::vector<Position> positions;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        constexpr int steps = 40;
        for (int k = 0; k <= steps; ++k) {
            const double s = static_cast<double>(k) / steps;
            const Position &a = corners[i - 1], &b = corners[i];
            positions.push_back({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)});
        }
    }
    return positions;
}

void draw_points(Svg& svg, const Scatter& scatter, const Axes& axes) {
    for (const Point& p : scatter.points) {
        const std::string hint = fmt::format("{}: cost {}, error {} in {}", p.tracer, brief(p.cost),
                                             brief(p.error), p.worst_case);
        svg.dot(axes.position(p.cost, p.error), 4.5, hint,
                fmt::format("mark {}{}", colours[kind_of(p)], p.efficient ? "" : " hollow"));
    }
}

/// Adds the area that a mark covers, as points so close together that no label fits between them.
void add_mark(Position at, std::vector<Position>& positions) {
    for (const double x : {-5.0, 0.0, 5.0}) {
        for (const double y : {-5.0, 0.0, 5.0}) positions.push_back({at.x + x, at.y + y});
    }
}

/// Draws the labels of the points for which `is_named` holds.
template <class F>
void draw_labels(Svg& svg, const Scatter& scatter, const Axes& axes, std::vector<Position> avoid,
                 const F& is_named) {
    std::vector<Label> labels;
    std::vector<std::string_view> classes;
    for (const Point& p : scatter.points) {
        if (!is_named(p)) {
            add_mark(axes.position(p.cost, p.error), avoid);
            continue;
        }
        labels.push_back({p.tracer, p.efficient, axes.position(p.cost, p.error)});
        classes.push_back(colours[kind_of(p)]);
    }
    const PlotArea& plot_area = axes.plot_area();
    place_labels(labels,
                 {plot_area.left, plot_area.top - 26, plot_area.width - 4, plot_area.bottom + 10},
                 avoid);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const Label& label = labels[i];
        if (label.is_far) svg.line(label.mark, leader_end(label), "leader");
        svg.text(label.at, label.anchor, label.text,
                 fmt::format("halo name {}{}", classes[i], label.is_bold ? " strong" : ""));
    }
}

template <class F>
void draw(Svg& svg, const Scatter& scatter, const Axes& axes, const F& is_named) {
    const std::vector<Position> corners = frontier(scatter, axes);
    draw_ticks(svg, axes);
    svg.polyline(corners, "frontier");
    draw_labels(svg, scatter, axes, along(corners), is_named);
    draw_points(svg, scatter, axes);
}

PlotTexts texts_of(const Scatter& scatter, const std::string& shape) {
    return {shape + ": error against cost", cost_axis(scatter), std::string(error_axis)};
}

/// Returns the content of the image as text.
std::string description_of(const Scatter& scatter, const PlotTexts& texts) {
    std::string text = texts.cost + "; " + texts.error + ".";
    for (const Point& p : scatter.points) {
        text += fmt::format(" {}: {}, {}{}.", p.tracer, brief(p.cost), brief(p.error),
                            p.efficient ? " (in the Pareto set)" : "");
    }
    return text;
}

template <class F>
std::string draw_small(const Scatter& scatter, const PlotTexts& texts,
                       const std::string& description, const F& is_named) {
    Svg svg(small.width, small.height, texts.title, description);
    svg.text({0, 12}, Anchor::start, texts.error, "small");
    svg.text({small.right, small.bottom + 48}, Anchor::end, texts.cost, "small");
    draw(svg, scatter, Axes(scatter, small), is_named);
    return svg.inlined();
}

}  // namespace

std::string plot(const std::vector<Row>& rows, const std::string& shape,
                 const std::vector<std::string>& remarks) {
    const Scatter scatter = scatter_of(rows, shape);
    if (scatter.points.empty()) return {};
    const PlotTexts texts = texts_of(scatter, shape);
    const std::vector<std::string> lines = lines_of(remarks);
    Svg svg(large.width, large.height + line_height * static_cast<double>(lines.size()),
            texts.title, description_of(scatter, texts));
    draw_titles(svg, shape, scatter);
    draw_key(svg, scatter);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double y = large.height + line_height * static_cast<double>(i);
        svg.text({margin, y}, Anchor::start, lines[i], "small");
    }
    draw(svg, scatter, Axes(scatter, large), [](const Point&) { return true; });
    return svg.standalone();
}

std::string small_plot(const std::vector<Row>& rows, const std::string& shape) {
    const Scatter scatter = scatter_of(rows, shape);
    if (scatter.points.empty()) return {};
    PlotTexts texts = texts_of(scatter, shape);
    const std::string description = description_of(scatter, texts);
    texts.error = "error";
    return draw_small(scatter, texts, description, [](const Point& p) { return p.efficient; });
}

std::string small_plot(const Scatter& scatter, const PlotTexts& texts) {
    if (scatter.points.empty()) return {};
    return draw_small(scatter, texts, description_of(scatter, texts),
                      [](const Point&) { return true; });
}

}  // namespace etalon::accuracy
