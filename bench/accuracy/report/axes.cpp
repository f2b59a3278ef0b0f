#include "bench/accuracy/report/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace etalon::accuracy {
namespace {

std::string power_of_ten(int exponent) {
    constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    if (exponent <= 1) return exponent == 0 ? "1" : "10";
    return fmt::format("10{}", digits[static_cast<std::size_t>(exponent)]);
}

}  // namespace

/// A margin of a twelfth keeps marks off the axes. There is at least a factor of two in cost to
/// see, and of ten in error.
Axes::Axes(const Scatter& scatter) : is_relative_(!scatter.unit.empty()) {
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

Place Axes::place(double cost, double error) const {
    const double x = (std::log10(cost) - lowest_) / (highest_ - lowest_);
    const double y = std::log10(1 + error) / worst_;
    return {left + x * (right - left), bottom - y * (bottom - top)};
}

/// 1, 2, 5 of each decade; more where that would be hardly any.
std::vector<Tick> Axes::cost_ticks() const {
    const std::vector<double> few{1, 2, 5}, many{1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8};
    std::vector<Tick> ticks;
    for (int decade = -3; decade < 9; ++decade) {
        for (const double step : highest_ - lowest_ > 0.8 ? few : many) {
            const double value = step * std::pow(10, decade), place = std::log10(value);
            if (place < lowest_ || place > highest_) continue;
            ticks.push_back({value, fmt::format("{}{:g}", is_relative_ ? "×" : "", value)});
        }
    }
    return ticks;
}

std::vector<Tick> Axes::error_ticks() const {
    std::vector<Tick> ticks{{0, "0"}};
    for (int exponent = 0; exponent < 10; ++exponent) {
        const double value = std::pow(10, exponent);
        if (std::log10(1 + value) <= worst_ + 1e-9)
            ticks.push_back({value, power_of_ten(exponent)});
    }
    return ticks;
}

}  // namespace etalon::accuracy
