#include "bench/plot/labels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace etalon::plot {
namespace {

constexpr double ascent = 11, descent = 4, padding = 3, mark_radius = 7;

double width_of(const Label& label) {
    // Continuation bytes of UTF-8 are not counted.
    const auto characters = std::count_if(label.text.begin(), label.text.end(),
                                          [](unsigned char c) { return (c & 0xC0) != 0x80; });
    return (label.is_bold ? 8.0 : 7.0) * static_cast<double>(characters);
}

double overlap(const Rectangle& a, const Rectangle& b) {
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return width > 0 && height > 0 ? width * height : 0;
}

Rectangle around(Position p, double radius) {
    return {p.x - radius, p.y - radius, p.x + radius, p.y + radius};
}

/// Returns the length within `r` of the line from `a` to `b`, sampled in steps along it.
double crossing(Position a, Position b, const Rectangle& r) {
    constexpr int steps = 16;
    double inside = 0;
    for (int i = 1; i < steps; ++i) {
        const double s = static_cast<double>(i) / steps;
        inside += overlap(around({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)}, 1), r);
    }
    return inside;
}

/// Returns candidate positions beside, above and below the mark, at increasing distances.
std::vector<Label> candidates(const Label& label) {
    std::vector<Label> list;
    const auto add = [&](double x, double y, Anchor anchor, bool is_far) {
        const Position at{label.mark.x + x, label.mark.y + y};
        list.push_back({label.text, label.is_bold, label.mark, at, anchor, is_far});
    };
    for (const double y : {4.0, -6.0, 14.0}) {
        add(10, y, Anchor::start, false);
        add(-10, y, Anchor::end, false);
    }
    add(0, -11, Anchor::middle, false);
    add(0, 21, Anchor::middle, false);
    for (double y = 26; y < 120; y += 17) {
        for (const double side : {-y, y}) {
            add(0, side, Anchor::middle, true);
            for (const double x : {-4.0, 20.0}) {
                add(x, side, Anchor::start, true);
                add(-x, side, Anchor::end, true);
            }
        }
    }
    return list;
}

/// Returns the cost of a label's position: the area that it covers, and its distance.
double placement_cost(const Label& label, const std::vector<Label>& all, std::size_t self,
                      const Rectangle& page, const std::vector<Position>& avoid) {
    const Rectangle here = extent(label);
    const double area = (here.right - here.left) * (here.bottom - here.top);
    double covered = 100 * (area - overlap(here, page));
    for (std::size_t i = 0; i < all.size(); ++i) {
        covered += 10 * overlap(here, around(all[i].mark, mark_radius));
        if (i == self) continue;
        const Rectangle other = extent(all[i]);
        covered += 10 * overlap(here, other);
        if (label.is_far) covered += 50 * crossing(label.mark, leader_end(label), other);
        if (label.is_far)
            covered += crossing(label.mark, leader_end(label), around(all[i].mark, mark_radius));
        if (all[i].is_far) covered += 50 * crossing(all[i].mark, leader_end(all[i]), here);
    }
    for (const Position& p : avoid) covered += 3 * overlap(here, around(p, 2));
    const Position end = leader_end(label);
    return covered + std::hypot(end.x - label.mark.x, end.y - label.mark.y);
}

/// Moves each label in turn to its best position while the others stay, until none moves. Returns
/// the sum of all costs.
double place_in_turn(std::vector<Label>& labels, const std::vector<std::size_t>& order,
                     const Rectangle& page, const std::vector<Position>& avoid) {
    for (Label& label : labels) label = candidates(label).front();
    constexpr int rounds = 20;
    double sum = 0;
    for (int round = 0; round < rounds; ++round) {
        sum = 0;
        for (const std::size_t i : order) {
            double least = placement_cost(labels[i], labels, i, page, avoid);
            for (const Label& c : candidates(labels[i])) {
                const double bad = placement_cost(c, labels, i, page, avoid);
                if (bad < least) least = bad, labels[i] = c;
            }
            sum += least;
        }
    }
    return sum;
}

}  // namespace

Rectangle extent(const Label& label) {
    const double width = width_of(label);
    double left = label.at.x;
    if (label.anchor == Anchor::middle) left -= width / 2;
    if (label.anchor == Anchor::end) left -= width;
    return {left - padding, label.at.y - ascent, left + width + padding, label.at.y + descent};
}

Position leader_end(const Label& label) {
    const Rectangle r = extent(label);
    return {std::clamp(label.mark.x, r.left, r.right),
            label.mark.y > r.bottom ? r.bottom + 1 : std::max(label.mark.y, r.top)};
}

void place_labels(std::vector<Label>& labels, const Rectangle& page,
                  const std::vector<Position>& avoid) {
    std::vector<std::size_t> order(labels.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<Label> other = labels;
    const double bad = place_in_turn(labels, order, page, avoid);
    std::ranges::reverse(order);
    if (place_in_turn(other, order, page, avoid) < bad) labels = std::move(other);
}

}  // namespace etalon::plot
