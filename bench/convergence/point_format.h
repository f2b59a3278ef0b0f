// Formatting of a curve's points in tables and JSON.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/numerics/vec.h"

namespace etalon::convergence {

/// Returns "1.234e-05"; "-" for an unknown value.
inline std::string scientific(double value) {
    return std::isnan(value) ? "-" : fmt::format("{:.3e}", value);
}

/// Returns the samples per pixel; "-" if they are unknown.
inline std::string spp_text(double samples) {
    return samples > 0 ? fmt::format("{:.2f}", samples) : "-";
}

/// Returns "+0.12 -0.03 +0.00": three fractions as percent; "-" for nothing.
inline std::string percent_text(const std::optional<Vec3>& parts) {
    if (!parts) return "-";
    return fmt::format("{:+.2f} {:+.2f} {:+.2f}", 100 * parts->x, 100 * parts->y, 100 * parts->z);
}

/// Returns a list of red, green and blue; null for nothing and if one is not finite.
inline nlohmann::ordered_json json_of(const std::optional<Vec3>& color) {
    using Json = nlohmann::ordered_json;
    const bool is_finite = color && std::isfinite(color->x + color->y + color->z);
    return is_finite ? Json({color->x, color->y, color->z}) : Json();
}

}  // namespace etalon::convergence
