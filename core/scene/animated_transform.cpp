#include "core/scene/animated_transform.h"

#include <algorithm>
#include <cmath>

#include "core/numerics/polar.h"

namespace etalon {
namespace {

/// Cosine of their angle above which quaternions are interpolated along their chord, as in pbrt-v3.
constexpr double nearly_equal = 0.9995;

Vec3 between(double part, const Vec3& a, const Vec3& b) {
    return (1 - part) * a + part * b;
}

Affine product(const Affine& rotation, const Affine& stretch) {
    return {rotation.vector(stretch.x), rotation.vector(stretch.y), rotation.vector(stretch.z)};
}

/// Returns the stretch that gives a map if a rotation follows it. The origin is left out.
Affine stretch_before(const Affine& rotation, const Affine& map) {
    const auto back = [&](const Vec3& v) {
        return Vec3(rotation.x.dot(v), rotation.y.dot(v), rotation.z.dot(v));
    };
    return {back(map.x), back(map.y), back(map.z)};
}

}  // namespace

AnimatedTransform::AnimatedTransform(const Affine& start, const Affine& end,
                                     const MotionTimes& times)
    : times_(times),
      start_(start),
      end_(end),
      from_(quaternion_of(polar_parts(start).rotation)),
      to_(quaternion_of(polar_parts(end).rotation)),
      stretches_{stretch_before(rotation_of(from_), start), stretch_before(rotation_of(to_), end)} {
    if (from_.dot(to_) < 0) to_ = -1 * to_;
    const double cosine = std::min(from_.dot(to_), 1.0);
    across_ = cosine > nearly_equal ? from_ : normalized(to_ + -cosine * from_);
    angle_ = std::acos(cosine);
}

bool AnimatedTransform::is_translation() const {
    return start_.x == end_.x && start_.y == end_.y && start_.z == end_.z;
}

Affine AnimatedTransform::at_part(double part) const {
    if (part <= 0) return start_;
    if (part >= 1) return end_;
    Affine map = start_;
    if (!is_translation()) {
        const auto& [s, e] = stretches_;
        map = product(rotation_at_part(part),
                      {between(part, s.x, e.x), between(part, s.y, e.y), between(part, s.z, e.z)});
    }
    map.origin = origin_at_part(part);
    return map;
}

Vec3 AnimatedTransform::origin_at_part(double part) const {
    return between(part, start_.origin, end_.origin);
}

Affine AnimatedTransform::rotation_at_part(double part) const {
    if (from_.dot(to_) > nearly_equal) {
        return rotation_of(normalized((1 - part) * from_ + part * to_));
    }
    const double angle = angle_ * part;
    return rotation_of(std::cos(angle) * from_ + std::sin(angle) * across_);
}

/// A point x moves along o + R S x, where o and S change linearly. Its distance from the chord is
/// at most length^2 / 8 times the largest second derivative, R'' S x + 2 R' S' x. For a rotation by
/// the angle a in total, |R'| <= a and |R''| <= a^2; along the chord of quaternions, where a <
/// 0.064, less than a tenth more. |S x| is largest at a corner of the box and at an end. The last
/// term covers the roundings, most of which come from R and S.
double AnimatedTransform::deviation(const Box3& box, double length) const {
    double reach = 0, change = 0;
    for_each_corner(box, [&](const Vec3& corner) {
        const Vec3 first = stretches_[0].vector(corner), last = stretches_[1].vector(corner);
        reach = std::max({reach, first.length(), last.length()});
        change = std::max(change, (last - first).length());
    });
    const double turn = 2 * angle_;
    const double bend = 1.1 * length * length / 8 * (turn * turn * reach + 2 * turn * change);
    const double origin = std::max(max_abs(start_.origin), max_abs(end_.origin));
    return is_translation() ? 0x1p-44 * origin : bend + 0x1p-44 * (reach + origin);
}

double AnimatedTransform::stretch_change(double length) const {
    const auto& [s, e] = stretches_;
    const Vec3 x = e.x - s.x, y = e.y - s.y, z = e.z - s.z;
    return length * std::sqrt(x.dot(x) + y.dot(y) + z.dot(z));
}

AnimatedTransform AnimatedTransform::after(double factor, const Vec3& offset) const {
    const auto larger = [&](const Affine& m, const Vec3& origin) {
        return Affine{factor * m.x, factor * m.y, factor * m.z, origin};
    };
    AnimatedTransform result = *this;
    for (Affine* map : {&result.start_, &result.end_}) {
        *map = larger(*map, factor * map->origin + offset);
    }
    for (Affine& stretch : result.stretches_) stretch = larger(stretch, Vec3(0));
    return result;
}

}  // namespace etalon
