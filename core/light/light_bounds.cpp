#include "core/light/light_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).length(), a.dot(b));
}

EmissionCone united(EmissionCone a, EmissionCone b) {
    if (b.spread > a.spread) std::swap(a, b);
    const bool two_sided = a.two_sided || b.two_sided;
    a.two_sided = two_sided;
    a.emission = std::max(a.emission, b.emission);
    if (two_sided && a.axis.dot(b.axis) < 0) b.axis = -b.axis;
    const double between = angle_between(a.axis, b.axis);
    if (std::min(between + b.spread, pi) <= a.spread) return a;
    const double spread = (a.spread + between + b.spread) / 2;
    const Vec3 side = b.axis - a.axis.dot(b.axis) * a.axis;
    const double length = side.length();
    if (spread >= pi || !(length > 0)) {
        a.spread = pi;
        return a;
    }
    const double turn = spread - a.spread;
    a.axis = normalized(std::cos(turn) * a.axis + std::sin(turn) / length * side);
    a.spread = spread;
    return a;
}

/// Returns the integral over directions of how far lights of the cone shine into them.
double measure(const EmissionCone& cone) {
    const double o = cone.spread, w = std::min(o + cone.emission, pi);
    return 2 * pi * (1 - std::cos(o)) +
           pi / 2 * (2 * w * std::sin(o) - std::cos(o - 2 * w) - 2 * o * std::sin(o) + std::cos(o));
}

}  // namespace

LightBounds united(const LightBounds& a, const LightBounds& b) {
    if (!(a.intensity > 0)) return b;
    if (!(b.intensity > 0)) return a;
    LightBounds both{a.box, united(a.cone, b.cone), a.intensity + b.intensity};
    both.box.extendBy(b.box);
    return both;
}

/// Returns whether the angles that united() compares say so, whatever their roundings.
bool BoundsSum::surely_contains(const EmissionCone& cone) const {
    constexpr double slack = 1e-12;  // thousands of roundings of cosines and of the angles
    if (cone.spread != 0) return false;
    const double cosine = sum_.cone.axis.dot(cone.axis);
    const bool two_sided = sum_.cone.two_sided || cone.two_sided;
    return (two_sided ? std::abs(cosine) : cosine) > cos_spread_ + slack;
}

void BoundsSum::add(const LightBounds& light) {
    if (sum_.intensity > 0 && light.intensity > 0 && surely_contains(light.cone)) {
        sum_.cone.emission = std::max(sum_.cone.emission, light.cone.emission);
        sum_.cone.two_sided = sum_.cone.two_sided || light.cone.two_sided;
        sum_.box.extendBy(light.box);
        sum_.intensity += light.intensity;
        return;
    }
    sum_ = united(sum_, light);
    cos_spread_ = std::cos(sum_.cone.spread);
}

double cluster_cost(const LightBounds& bounds) {
    const double sides = bounds.cone.two_sided ? 2 : 1;
    return bounds.intensity * sides * measure(bounds.cone) * bounds.box.size().length2();
}

}  // namespace etalon
