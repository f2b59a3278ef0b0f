#include "core/scene/revolved.h"

#include <algorithm>
#include <numbers>

namespace etalon {
namespace {

/// Returns cosine and sine; exact for multiples of a quarter turn.
Vec2 direction_at(double degrees) {
    const std::array<Vec2, 4> quarters = {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)};
    const double quarter = degrees / 90;
    if (quarter == std::floor(quarter)) return quarters[static_cast<std::size_t>(quarter) % 4];
    const double angle = degrees * (std::numbers::pi / 180);
    return {std::cos(angle), std::sin(angle)};
}

Vec2 turned(const Vec2& v, const Vec2& by) {
    return {v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x};
}

bool is_finite(const Vec2& v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

bool is_finite(const TurningDirection& d) {
    return is_finite(d.at) && is_finite(d.per_height);
}

/// Returns a bound on how much a rounding of local coordinates moves a point, in roundings of its
/// distance; 3 if the images of the axes are orthogonal.
double condition(const Affine& map, const LocalFrame& frame) {
    return map.x.length() * frame.length(0) + map.y.length() * frame.length(1) +
           map.z.length() * frame.length(2);
}

}  // namespace

Sector::Sector(double degrees, const TurningDirection& start)
    : from(start),
      angle(degrees * (std::numbers::pi / 180)),
      is_whole(degrees >= 360),
      is_convex(degrees <= 180) {
    const Vec2 by = direction_at(std::clamp(degrees, 0.0, 360.0));
    to = {turned(start.at, by), turned(start.per_height, by)};
}

Revolved::Revolved(const Affine& map, const Profile& curve, const Sector& part)
    : to_world(map),
      frame(map, Symmetry::none),
      is_sheared(!(condition(map, frame) < 8)),
      profile(curve),
      sector(part) {}

bool Revolved::exists() const {
    const auto& [along, squares, low, high, falls] = profile;
    const bool is_clipped = std::isfinite(low) && std::isfinite(high) && low < high;
    const auto is_number = [](double x) { return std::isfinite(x); };
    const auto is_zero = [](double x) { return x == 0; };
    const bool is_curve = profile.is_flat() ? low >= 0
                                            : std::ranges::all_of(squares, is_number) &&
                                                  !std::ranges::all_of(squares, is_zero);
    return frame.exists() && is_clipped && is_curve && sector.angle > 0 && is_finite(sector.from) &&
           is_finite(sector.to);
}

}  // namespace etalon
