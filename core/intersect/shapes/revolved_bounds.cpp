// The box of a surface of revolution.
#include <numbers>
#include <optional>

#include "core/intersect/shapes/revolved.h"

namespace etalon {
namespace {

struct Range {
    double low, high;
};

double furthest_from_zero(const Range& heights) {
    return std::max(std::abs(heights.low), std::abs(heights.high));
}

/// Returns the largest sum of terms of the profile's square between two heights.
double terms_of_square(const Profile& profile, const Range& heights) {
    const auto& q = profile.squares;
    const double far = furthest_from_zero(heights);
    return std::abs(q[0]) + far * (std::abs(q[1]) + far * std::abs(q[2]));
}

/// Returns the range of radii between two heights, rounded outward.
Range radii(const Profile& profile, const Range& heights) {
    const auto& q = profile.squares;
    const double a = profile.square(heights.low), b = profile.square(heights.high);
    Range squares{std::min(a, b), std::max(a, b)};
    const double vertex = -0.5 * q[1] / q[2];
    if (vertex > heights.low && vertex < heights.high) {
        const double there = profile.square(vertex);
        squares = {std::min(squares.low, there), std::max(squares.high, there)};
    }
    const double error = 16 * unit_roundoff * terms_of_square(profile, heights);
    return {std::sqrt(std::max(0.0, squares.low - error)),
            std::sqrt(std::max(0.0, squares.high + error))};
}

/// Returns the largest across r + up z of the curve's points (r, z), from boxes of its pieces.
double reach_of_pieces(const Profile& p, double across, double up) {
    constexpr int pieces = 64;
    double furthest = -infinity, below = p.low;
    for (int i = 1; i <= pieces; ++i) {
        const double above = i == pieces ? p.high : p.low + (p.high - p.low) * i / pieces;
        const Range around = radii(p, {below, above});
        furthest = std::max(furthest, std::max(across * around.low, across * around.high) +
                                          std::max(up * below, up * above));
        below = above;
    }
    return furthest;
}

/// The same for an ellipse, with squares[2] < 0: in (R sin a / sqrt(c), R cos a) about its middle
/// it is a sum of a cosine and a sine.
std::optional<double> reach_of_ellipse(const Profile& p, double across, double up) {
    const auto& q = p.squares;
    const double c = -q[2], middle = 0.5 * q[1] / c;
    const double radius = std::sqrt(std::max(0.0, q[0] + 0.25 * q[1] * q[1] / c));
    const double length = std::sqrt(across * across + up * up / c);
    const double at = middle + radius * (up / c) / length;
    if (!(at > p.low && at < p.high)) return std::nullopt;
    return up * middle + radius * length;
}

/// The same for a parabola, with squares[2] = 0, where it rises against `up`.
std::optional<double> reach_of_parabola(const Profile& p, double across, double up) {
    const auto& q = p.squares;
    const double radius = -0.5 * across * q[1] / up, at = (radius * radius - q[0]) / q[1];
    if (!(radius > 0 && at > p.low && at < p.high)) return std::nullopt;
    return -up * q[0] / q[1] - 0.25 * across * across * q[1] / up;
}

/// Returns the largest across r + up z of the curve's points (r, z). r is a convex function of z if
/// the square's discriminant is negative, and a concave one if it is positive, so that the furthest
/// point is an end or a point where the slope vanishes.
double reach(const Profile& p, double across, double up) {
    const auto& q = p.squares;
    const auto reach_at = [&](double z) {
        const Range r = radii(p, {z, z});
        return std::max(across * r.low, across * r.high) + up * z;
    };
    const double ends = std::max(reach_at(p.low), reach_at(p.high));
    const bool is_straight = q[1] == 0 && (q[2] == 0 || (q[0] == 0 && p.low * p.high >= 0));
    if (is_straight) return ends;
    const bool is_convex = q[1] * q[1] < 4 * q[0] * q[2];
    if (across >= 0 && is_convex) return ends;
    if (across >= 0 && q[2] < 0)
        return std::max(ends, reach_of_ellipse(p, across, up).value_or(ends));
    if (across >= 0 && q[2] == 0) {
        return std::max(ends, reach_of_parabola(p, across, up).value_or(ends));
    }
    if (across <= 0 && q[2] <= 0) return ends;  // a concave r is seen from behind, too
    return reach_of_pieces(p, across, up);
}

/// Returns the largest component along (x, y) of unit vectors in the sector. The sector must not
/// turn.
double reach(const Sector& sector, double x, double y) {
    const TurningDirection &from = sector.from, &to = sector.to;
    const double length = std::hypot(x, y);
    if (sector.is_whole) return length;
    const bool after = from.at.x * y - from.at.y * x >= 0, before = x * to.at.y - y * to.at.x >= 0;
    if (sector.is_convex ? after && before : after || before) return length;
    const auto along = [&](const Vec2& at) {
        return (x * at.x + y * at.y) / std::hypot(at.x, at.y);
    };
    return std::max(along(from.at), along(to.at));
}

/// The angles of a sector over a range of heights, from `begin` on. A direction
/// that turns by 1.5 or more counts as a whole turn.
struct Turn {
    Turn(const Sector& sector, const Range& heights) {
        const Vec2 a = sector.from(heights.low), b = sector.from(heights.high);
        const double change = std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
        begin = std::atan2(a.y, a.x) + std::min(change, 0.0);
        angle = sector.angle + std::abs(change);
        is_whole = sector.is_whole || !(std::abs(change) < 1.5);
    }

    /// Returns the largest cosine of the angle between `to` and one of them.
    double largest_cosine(double to) const {
        constexpr double turn = 2 * std::numbers::pi;
        const double from_begin = to - begin - turn * std::floor((to - begin) / turn);
        if (is_whole || from_begin <= angle) return 1;
        return std::max(std::cos(from_begin), std::cos(from_begin - angle));
    }

    double begin, angle;
    bool is_whole;
};

/// Returns how far a surface that turns with the height reaches along a row of the map, from its
/// pieces.
double reach_of_turning(const Revolved& s, const Vec3& row) {
    constexpr int pieces = 64;
    const Profile& p = s.profile;
    const double length = std::hypot(row.x, row.y), towards = std::atan2(row.y, row.x);
    double furthest = -infinity, below = p.low;
    for (int i = 1; i <= pieces; ++i) {
        const double above = i == pieces ? p.high : p.low + (p.high - p.low) * i / pieces;
        const Range around = radii(p, {below, above});
        const double across = length * Turn(s.sector, {below, above}).largest_cosine(towards);
        furthest = std::max(furthest, std::max(across * around.low, across * around.high) +
                                          std::max(row.z * below, row.z * above));
        below = above;
    }
    return furthest;
}

/// Returns how far the surface reaches along a row of the map.
double reach(const Revolved& s, const Vec3& row) {
    if (s.sector.from.turns() && !s.sector.is_whole) return reach_of_turning(s, row);
    const double across = reach(s.sector, row.x, row.y);
    const Profile& p = s.profile;
    if (p.is_flat()) return std::max(across * p.low, across * p.high);
    return reach(p, across, row.z);
}

}  // namespace

/// The roundings of a sum of terms, of the closed forms and of the angles are less than 128 of the
/// terms.
Box3 bounds(const Geometry&, const Revolved& s) {
    if (!s.exists()) return {};
    const Affine& m = s.to_world;
    const Range heights = s.profile.is_flat() ? Range{0, 0} : Range{s.profile.low, s.profile.high};
    const double radius = s.profile.is_flat() ? s.profile.high : radii(s.profile, heights).high;
    if (!(radius > 0)) return {};
    Box3 box;
    for (int k = 0; k < 3; ++k) {
        const Vec3 row(m.x[k], m.y[k], m.z[k]);
        const double terms = std::abs(m.origin[k]) + radius * std::hypot(row.x, row.y) +
                             furthest_from_zero(heights) * std::abs(row.z);
        const double error = 128 * unit_roundoff * terms;
        box.max[k] = m.origin[k] + reach(s, row) + error;
        box.min[k] = m.origin[k] - reach(s, -row) - error;
    }
    return box;
}

}  // namespace etalon
