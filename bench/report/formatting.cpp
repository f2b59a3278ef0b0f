#include "bench/report/formatting.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bench/speed/timed_tracer.h"

namespace etalon::bench_report {

std::string count_of(std::uint64_t n, const std::string& what) {
    return grouped(n) + " " + what + (n == 1 ? "" : "s");
}

std::string three_digits(double value) {
    if (value == 0 || !std::isfinite(value)) return fmt::format("{}", value);
    const double magnitude = std::abs(value);
    if (magnitude >= 999.5 && magnitude < 1e15)
        return fmt::format("{}{}", value < 0 ? "-" : "",
                           grouped(static_cast<std::uint64_t>(magnitude + 0.5)));
    if (magnitude >= 99.95) return fmt::format("{:.0f}", value);
    if (magnitude >= 9.995) return fmt::format("{:.1f}", value);
    if (magnitude >= 0.9995) return fmt::format("{:.2f}", value);
    return magnitude >= 0.000995 ? fmt::format("{:.3f}", value) : fmt::format("{:.1e}", value);
}

std::string times(const statistics::Estimate& ratio) {
    const std::string text = "×" + three_digits(ratio.median);
    return ratio.spread > 0 ? fmt::format("{} ± {:.2f}", text, *ratio.spread) : text;
}

std::string duration(double seconds) {
    if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
    if (seconds < 119.5) return fmt::format("{:.0f} s", seconds);
    const int minutes = static_cast<int>(seconds / 60 + 0.5);
    if (minutes < 60) return fmt::format("{} min", minutes);
    return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

std::string bytes(double count) {
    constexpr std::array units = {"B", "kB", "MB", "GB", "TB"};
    std::size_t unit = 0;
    for (; count >= 999.5 && unit + 1 < units.size(); ++unit) count /= 1000;
    return fmt::format("{} {}", three_digits(count), units[unit]);
}

Cell wrong_of(std::uint64_t wrong, std::uint64_t all) {
    return {fmt::format("{} of {}", grouped(wrong), grouped(all)),
            wrong > 0 ? Mark::bad : Mark::good};
}

int colour_of(std::string_view tracer) {
    const std::vector<std::string> names = speed::tracer_names();
    const bool is_backend = std::ranges::find(names, tracer) != names.end();
    return is_backend ? speed::find_tracer(std::string(tracer)).colour : Backend().colour;
}

}  // namespace etalon::bench_report
