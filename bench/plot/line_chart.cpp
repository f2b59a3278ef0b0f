#include "bench/plot/line_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/plot/labels.h"
#include "bench/plot/plot_area.h"
#include "bench/plot/ticks.h"

namespace etalon::plot {
namespace {

constexpr PlotArea plot_area{360, 300, 46, 348, 26, 250};

bool is_drawn(const Sample& s) {
    return s.x > 0 && s.y > 0 && std::isfinite(s.x) && std::isfinite(s.y);
}

bool has_band(const Sample& s) {
    return s.low > 0 && s.high > s.low && std::isfinite(s.high);
}

/// Range of an axis, as logarithms of base ten.
struct Range {
    void include(double value) {
        low = std::min(low, std::log10(value));
        high = std::max(high, std::log10(value));
    }
    /// Adds a margin and widens the range to at least a factor of two.
    void widen() {
        const double margin = std::max((high - low) / 20, (std::log10(2) - (high - low)) / 2);
        low -= margin;
        high += margin;
    }
    double share(double value) const { return (std::log10(value) - low) / (high - low); }

    double low = std::numeric_limits<double>::infinity(), high = -low;
};

/// The drawable points of a chart and its ranges.
struct Curves {
    explicit Curves(const LineChart& chart) : series(chart.series) {
        for (Series& s : series) {
            std::erase_if(s.samples, [](const Sample& sample) { return !is_drawn(sample); });
            for (const Sample& sample : s.samples) include(sample);
        }
        x.widen();
        y.widen();
    }

    bool empty() const {
        return std::all_of(series.begin(), series.end(),
                           [](const Series& s) { return s.samples.empty(); });
    }
    Position position(double at_x, double at_y) const {
        return plot_area.position(x.share(at_x), y.share(at_y));
    }

    std::vector<Series> series;
    Range x, y;

  private:
    void include(const Sample& s) {
        x.include(s.x);
        y.include(s.y);
        if (!has_band(s)) return;
        y.include(s.low);
        y.include(s.high);
    }
};

void draw_axes(Svg& svg, const LineChart& chart, const Curves& curves) {
    for (const Tick& tick : log_ticks(curves.y.low, curves.y.high)) {
        const double y = plot_area.position(0, curves.y.share(tick.value)).y;
        svg.line({plot_area.left, y}, {plot_area.right, y}, "grid");
        svg.text({plot_area.left - 6, y + 4}, Anchor::end, tick.text, "small");
    }
    for (const Tick& tick : log_ticks(curves.x.low, curves.x.high)) {
        const double x = plot_area.position(curves.x.share(tick.value), 0).x;
        svg.line({x, plot_area.top}, {x, plot_area.bottom}, "grid");
        svg.text({x, plot_area.bottom + 16}, Anchor::middle, tick.text, "small");
    }
    svg.text({0, 12}, Anchor::start, chart.y_name, "small");
    svg.text({plot_area.right, plot_area.bottom + 40}, Anchor::end, chart.x_name, "small");
}

std::string class_of(std::size_t series) {
    return fmt::format("c{}", series % 7 + 1);
}

void draw_band(Svg& svg, const Curves& curves, std::size_t which) {
    std::vector<Position> upper, lower;
    for (const Sample& s : curves.series[which].samples) {
        if (!has_band(s)) continue;
        upper.push_back(curves.position(s.x, s.high));
        lower.push_back(curves.position(s.x, s.low));
    }
    if (upper.size() < 2) return;
    upper.insert(upper.end(), lower.rbegin(), lower.rend());
    svg.polygon(upper, "band " + class_of(which));
}

void draw_curve(Svg& svg, const Curves& curves, std::size_t which) {
    const Series& series = curves.series[which];
    std::vector<Position> positions;
    for (const Sample& s : series.samples) positions.push_back(curves.position(s.x, s.y));
    if (positions.size() > 1) svg.polyline(positions, "curve " + class_of(which));
    for (const Sample& s : series.samples) {
        svg.dot(curves.position(s.x, s.y), 3,
                fmt::format("{}: {:.3g}, {:.3g}", series.name, s.x, s.y),
                "mark " + class_of(which));
    }
}

/// Returns points along the curves that are so close together that no name fits between them.
std::vector<Position> along(const Curves& curves) {
    constexpr int steps = 8;
    std::vector<Position> positions;
    for (const Series& series : curves.series) {
        for (std::size_t i = 0; i < series.samples.size(); ++i) {
            const Sample &s = series.samples[i], &before = series.samples[i > 0 ? i - 1 : i];
            const Position a = curves.position(before.x, before.y), b = curves.position(s.x, s.y);
            for (int k = 1; k <= steps; ++k) {
                const double share = static_cast<double>(k) / steps;
                positions.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
            }
        }
    }
    return positions;
}

void draw_names(Svg& svg, const Curves& curves) {
    std::vector<Label> labels;
    std::vector<std::size_t> whose;
    for (std::size_t i = 0; i < curves.series.size(); ++i) {
        if (curves.series[i].samples.empty()) continue;
        const Sample& last = curves.series[i].samples.back();
        labels.push_back({curves.series[i].name, true, curves.position(last.x, last.y)});
        whose.push_back(i);
    }
    place_labels(labels, {plot_area.left, 16, plot_area.width, plot_area.bottom}, along(curves));
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const Label& label = labels[i];
        if (label.is_far) svg.line(label.mark, leader_end(label), "leader");
        svg.text(label.at, label.anchor, label.text, "halo strong name " + class_of(whose[i]));
    }
}

std::string description_of(const LineChart& chart, const Curves& curves) {
    std::string text = chart.y_name + " against " + chart.x_name + ".";
    for (const Series& s : curves.series) {
        if (s.samples.empty()) continue;
        const Sample &first = s.samples.front(), &last = s.samples.back();
        text += fmt::format(" {}: {:.3g} at {:.3g} to {:.3g} at {:.3g}.", s.name, first.y, first.x,
                            last.y, last.x);
    }
    return text;
}

}  // namespace

std::string line_chart(const LineChart& chart) {
    const Curves curves(chart);
    if (curves.empty()) return {};
    Svg svg(plot_area.width, plot_area.height, chart.title, description_of(chart, curves));
    draw_axes(svg, chart, curves);
    for (std::size_t i = 0; i < curves.series.size(); ++i) draw_band(svg, curves, i);
    for (std::size_t i = 0; i < curves.series.size(); ++i) draw_curve(svg, curves, i);
    draw_names(svg, curves);
    return svg.inlined();
}

}  // namespace etalon::plot
