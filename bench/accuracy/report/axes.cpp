#include "bench/accuracy/report/axes.h"

#include <algorithm>
#include <cmath>

namespace etalon::accuracy {

using plot::Tick;

/// A margin of a twelfth keeps marks away from the axes. The axes span at least a factor of two in
/// cost and of ten in error.
Axes::Axes(const Scatter& scatter, const plot::PlotArea& plot_area)
    : plot_area_(plot_area), is_relative_(!scatter.unit.empty()) {
    const auto [cheapest, dearest] =
        std::minmax_element(scatter.points.begin(), scatter.points.end(),
                            [](const Point& a, const Point& b) { return a.cost < b.cost; });
    const double low = std::log10(cheapest->cost), high = std::log10(dearest->cost);
    const double margin = std::max((high - low) / 12, (std::log10(2) - (high - low)) / 2);
    lowest_ = low - margin;
    highest_ = high + margin;
    worst_ = 1;
    for (const Point& p : scatter.points) worst_ = std::max(worst_, std::log10(1 + p.error));
}

plot::Position Axes::position(double cost, double error) const {
    const double x = (std::log10(cost) - lowest_) / (highest_ - lowest_);
    return plot_area_.position(x, std::log10(1 + error) / worst_);
}

std::vector<Tick> Axes::cost_ticks() const {
    std::vector<Tick> ticks = plot::log_ticks(lowest_, highest_);
    if (is_relative_) {
        for (Tick& tick : ticks) tick.text = "×" + tick.text;
    }
    return ticks;
}

std::vector<Tick> Axes::error_ticks() const {
    std::vector<Tick> ticks{{0, "0"}};
    for (int exponent = 0; exponent < 10; ++exponent) {
        const double value = std::pow(10, exponent);
        if (std::log10(1 + value) <= worst_ + 1e-9)
            ticks.push_back({value, plot::power_of_ten(exponent)});
    }
    return ticks;
}

}  // namespace etalon::accuracy
