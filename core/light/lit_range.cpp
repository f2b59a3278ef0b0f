#include "core/light/lit_range.h"

#include <algorithm>

namespace etalon {
namespace {

struct Range {
    double begin, end;
};

/// Returns the part of a line within a spotlight's cone, which is narrower than a half space:
/// between the roots of ((p - apex).axis)^2 = cos^2 |p - apex|^2, or beyond one of them.
std::optional<Range> in_cone(const SpotSource& spot, const Vec3& origin, const Vec3& direction) {
    const Vec3 from = origin - spot.position;
    const double c2 = spot.cos_total * spot.cos_total;
    const double along = direction.dot(spot.axis), height = from.dot(spot.axis);
    const double a = along * along - c2, b = height * along - c2 * from.dot(direction),
                 c = height * height - c2 * from.dot(from);
    const double discriminant = b * b - a * c;
    if (a == 0 || discriminant < 0)
        return a < 0 ? std::nullopt : std::optional<Range>({-infinity, infinity});
    const double root = std::sqrt(discriminant);
    const double low = (-b - std::copysign(root, a)) / a, high = (-b + std::copysign(root, a)) / a;
    if (a > 0) return along > 0 ? Range{high, infinity} : Range{-infinity, low};
    if (height + along * (low + high) / 2 < 0) return std::nullopt;  // of the cone's other half
    return Range{low, high};
}

struct LitPart {
    std::optional<Range> operator()(const PointSource&) const { return Range{-infinity, infinity}; }
    std::optional<Range> operator()(const GoniometricSource&) const {
        return Range{-infinity, infinity};
    }
    std::optional<Range> operator()(const SpotSource& spot) const {
        if (!(spot.cos_total > 0)) return Range{-infinity, infinity};
        return in_cone(spot, origin, direction);
    }
    template <class Other>
    std::optional<Range> operator()(const Other&) const {
        return std::nullopt;
    }

    const Vec3 &origin, &direction;
};

/// Returns the position of a light that lit_range() handles.
struct LightPosition {
    template <class Source>
    Vec3 operator()(const Source& source) const {
        if constexpr (requires { source.position; }) return source.position;
        return Vec3(0);
    }
};

}  // namespace

std::optional<Equiangular> lit_range(const PhysicalLight& light, const Vec3& origin,
                                     const Vec3& direction, double length) {
    const std::optional<Range> part = std::visit(LitPart{origin, direction}, light);
    if (!part) return std::nullopt;
    const double begin = std::max(part->begin, 0.0), end = std::min(part->end, length);
    if (!(begin < end)) return std::nullopt;
    return Equiangular(std::visit(LightPosition{}, light), origin, direction, begin, end);
}

}  // namespace etalon
