#include "bench/plot/ticks.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace etalon::plot {
namespace {

/// Returns the ticks within a decade, by the number of decades that are shown.
std::vector<double> steps(double decades) {
    if (decades <= 0.8) return {1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8};
    if (decades <= 2.5) return {1, 2, 5};
    return {1};
}

std::string text_of(double value, double step, int exponent) {
    const bool is_long = exponent > 3 || exponent < -3;
    return is_long && step == 1 ? power_of_ten(exponent) : fmt::format("{:g}", value);
}

}  // namespace

std::string power_of_ten(int exponent) {
    constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    if (exponent == 0) return "1";
    if (exponent == 1) return "10";
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(exponent))) {
        text += digits[static_cast<std::size_t>(digit - '0')];
    }
    return text;
}

std::vector<Tick> log_ticks(double low, double high) {
    std::vector<Tick> ticks;
    const int every = std::max(1, static_cast<int>((high - low) / 8));
    const auto first = static_cast<int>(std::floor(low)), last = static_cast<int>(std::ceil(high));
    for (int exponent = first; exponent <= last; ++exponent) {
        if (exponent % every != 0) continue;
        for (const double step : steps(high - low)) {
            const double value = step * std::pow(10, exponent), place = std::log10(value);
            if (place < low || place > high) continue;
            ticks.push_back({value, text_of(value, step, exponent)});
        }
    }
    return ticks;
}

}  // namespace etalon::plot
