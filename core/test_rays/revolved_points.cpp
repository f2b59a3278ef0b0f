#include "core/test_rays/revolved_points.h"

#include <numbers>

namespace etalon {

Vec3 RevolvedPoints::at(double along, double around) const {
    const double value = profile_.low + along * (profile_.high - profile_.low);
    const double z = profile_.is_flat() ? 0 : value;
    const double r = profile_.is_flat() ? value : radius(z);
    const Vec2 from = sector_.from(z);
    const double angle = std::atan2(from.y, from.x) + around * sector_.angle;
    return {r * std::cos(angle), r * std::sin(angle), z};
}

Vec3 RevolvedPoints::on_surface(Random& random) const {
    const double along = random.uniform();
    return at(along, random.uniform());
}

Vec3 RevolvedPoints::on_axis(Random& random) const {
    const double share = random.uniform(-0.1, 1.1);
    if (profile_.is_flat()) return {0, 0, 0};
    return {0, 0, profile_.low + share * (profile_.high - profile_.low)};
}

Vec3 RevolvedPoints::on_rim(double off, Random& random) const {
    const double end = random.index(2) == 0 ? 0 : 1;
    return at(end + off - 1, random.uniform());
}

Vec3 RevolvedPoints::on_side(double off, Random& random) const {
    const double end = random.index(2) == 0 ? 0 : 1;
    return at(random.uniform(), end + off - 1);
}

/// Returns where the gradient, (x, y, -slope) with half of the squares' slope, is perpendicular to
/// the line of sight.
Vec3 RevolvedPoints::silhouette(const Vec3& from, double off, Random& random) const {
    const Vec3 p = on_surface(random);
    if (profile_.is_flat()) return p;
    const double slope = 0.5 * profile_.squares[1] + profile_.squares[2] * p.z;
    const double r = radius(p.z), away = std::hypot(from.x, from.y);
    const double cosine = (r * r + slope * (from.z - p.z)) / (r * away);
    const double opening = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double angle = std::atan2(from.y, from.x) + random.sign() * opening;
    return {off * r * std::cos(angle), off * r * std::sin(angle), p.z};
}

/// Returns where the gradient vanishes.
bool RevolvedPoints::is_tip(double z) const {
    const double slope = 0.5 * profile_.squares[1] + profile_.squares[2] * z;
    return !profile_.is_flat() && profile_.square(z) == 0 && slope == 0;
}

}  // namespace etalon
