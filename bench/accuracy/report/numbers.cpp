#include "bench/accuracy/report/numbers.h"

#include <fmt/format.h>

#include <cmath>

namespace etalon::accuracy {
namespace {

/// Shortens an exponent: "4.6e+04" becomes "4.6e4".
std::string scientific(double value, int decimals) {
    const std::string text = fmt::format("{:.{}e}", value, decimals);
    const auto e = text.find('e');
    std::string digits = text.substr(0, e);
    if (digits.ends_with(".0")) digits.resize(digits.size() - 2);
    return fmt::format("{}e{}", digits, std::stoi(text.substr(e + 1)));
}

}  // namespace

std::string brief(double value) {
    const double magnitude = std::abs(value);
    if (value == 0 || !std::isfinite(value)) return fmt::format("{}", value);
    if (magnitude >= 9999.5) return scientific(value, 1);
    if (magnitude >= 99.95) return fmt::format("{:.0f}", value);
    if (magnitude >= 9.995) return fmt::format("{:.1f}", value);
    if (magnitude >= 0.0995) return fmt::format("{:.2f}", value);
    if (magnitude >= 0.00995) return fmt::format("{:.3f}", value);
    return scientific(value, magnitude < 1e-9 ? 0 : 1);
}

std::string brief_count(std::uint64_t count) {
    if (count < 1000000) return fmt::format("{}", count);
    return scientific(static_cast<double>(count), 1);
}

}  // namespace etalon::accuracy
