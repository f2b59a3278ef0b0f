#include "app/common/units.h"

#include <fmt/format.h>

namespace etalon {

std::string grouped(std::uint64_t n) {
    std::string digits = std::to_string(n);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3) {
        digits.insert(static_cast<std::size_t>(at), 1, ',');
    }
    return digits;
}

std::string rays_text(std::uint64_t rays) {
    if (rays < 1'000'000) return grouped(rays) + (rays == 1 ? " ray" : " rays");
    return fmt::format("{:.2f} Mrays", 1e-6 * static_cast<double>(rays));
}

std::string seconds_text(double seconds) {
    return seconds < 0.9995 ? fmt::format("{:.1f} ms", 1e3 * seconds)
                            : fmt::format("{:.2f} s", seconds);
}

}  // namespace etalon
