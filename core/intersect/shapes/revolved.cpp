#include "core/intersect/shapes/revolved.h"

#include "core/intersect/shapes/charts.h"

namespace etalon {
namespace {

constexpr double u = unit_roundoff;

/// Returns the form at a point, with a bound on its error.
Approximate form_at(const Profile& profile, const Vec3& p) {
    if (profile.is_flat()) return {p.z, 0};
    const auto& q = profile.squares;
    const double circle = p.x * p.x + p.y * p.y;
    const double terms =
        circle + std::abs(q[0]) + std::abs(p.z) * (std::abs(q[1]) + std::abs(p.z * q[2]));
    return {circle - profile.square(p.z), 8 * u * terms};
}

/// Moves a point along the gradient onto the surface (Newton's method), as far as roundings allow.
Vec3 refined(const Profile& profile, Vec3 p) {
    for (int step = 0; step < 4; ++step) {
        const Approximate value = form_at(profile, p);
        if (std::abs(value.value) <= value.error) break;
        const Vec3 slope = gradient(profile, p);
        p -= value.value / slope.dot(slope) * slope;
    }
    return p;
}

/// Returns the point of the surface nearest to a place that is off by roundings; the place is
/// relative to the map's origin. The local coordinates of a sheared surface have a larger error
/// along the surface, which is measured in world space and corrected.
Vec3 local_point(const Revolved& s, const Vec3& seen) {
    const Vec3 local = refined(s.profile, s.frame.vector(seen));
    if (!s.is_sheared) return local;
    const Vec3 rest = seen - s.to_world.vector(local);
    const Vec3 normal = unit_vector(s.frame.normal(gradient(s.profile, local)));
    return refined(s.profile, local + s.frame.vector(rest - rest.dot(normal) * normal));
}

/// Returns the angle from the sector's first direction, as a fraction of the sector. For a point
/// that roundings have put outside, returns that of the nearer end.
double fraction_of_turn(const Sector& sector, const Vec3& local) {
    constexpr double turn = 2 * std::numbers::pi;
    const Vec2 from = sector.from(local.z);
    const double sine = from.x * local.y - from.y * local.x,
                 cosine = from.x * local.x + from.y * local.y;
    double angle = std::atan2(sine, cosine);
    if (angle < 0) angle += turn;
    if (angle <= sector.angle) return angle / sector.angle;
    return angle - sector.angle < turn - angle ? 1 : 0;
}

/// Returns how a point moves with the height, at a radius that is not zero; zero at a tip.
Vec3 along_height(const Profile& profile, const Vec3& local) {
    const auto& q = profile.squares;
    const double radius = std::hypot(local.x, local.y);
    const double growth = (0.5 * q[1] + q[2] * local.z) / radius;
    if (!std::isfinite(growth)) return Vec3(0);
    return growth * outward(local) + Vec3(0, 0, 1);
}

/// Returns how the line from which the surface is swept moves with its height, rotated so that it
/// passes the point.
Vec3 along_line(const Sector& sector, const Vec3& local) {
    const Vec2 from = sector.from(local.z), step = sector.from.per_height;
    const double length2 = from.dot(from);
    if (!(length2 > 0)) return Vec3(0);
    const double cosine = (from.x * local.x + from.y * local.y) / length2,
                 sine = (from.x * local.y - from.y * local.x) / length2;
    const double size = std::hypot(cosine, sine);
    if (!(size > 0)) return Vec3(0);
    return {(cosine * step.x - sine * step.y) / size, (sine * step.x + cosine * step.y) / size, 1};
}

struct Coordinate {
    double value;
    Vec3 derivative;
};

/// Returns v, before it is reversed.
Coordinate coordinate_along(const Revolved& s, const Vec3& local) {
    const Profile& p = s.profile;
    const double span = p.high - p.low;
    if (p.along == Profile::Along::radius) {
        const double radius = std::hypot(local.x, local.y);
        return {(radius - p.low) / span, span * outward(local)};
    }
    if (p.along == Profile::Along::angle) {
        const double first = std::acos(std::clamp(p.low, -1.0, 1.0)),
                     last = std::acos(std::clamp(p.high, -1.0, 1.0));
        const double radius = std::hypot(local.x, local.y);
        const double theta = std::atan2(radius, local.z);
        return {(theta - first) / (last - first),
                (last - first) * (local.z * outward(local) - Vec3(0, 0, radius))};
    }
    const Vec3 step =
        p.along == Profile::Along::line ? along_line(s.sector, local) : along_height(p, local);
    return {(local.z - p.low) / span, span * step};
}

Parametrization chart(const Revolved& s, const Vec3& local) {
    Coordinate v = coordinate_along(s, local);
    if (s.profile.falls) v = {1 - v.value, -v.derivative};
    const Vec3 dpdu = s.sector.angle * Vec3(-local.y, local.x, 0);
    return {{fraction_of_turn(s.sector, local), saturated(v.value)}, dpdu, v.derivative};
}

}  // namespace

Vec3 gradient(const Profile& profile, const Vec3& p) {
    if (profile.is_flat()) return {0, 0, 1};
    const Vec3 slope(2 * p.x, 2 * p.y, -profile.squares[1] - 2 * profile.squares[2] * p.z);
    return slope == Vec3(0) ? Vec3(0, 0, 1) : slope;
}

/// Keeps the tangent part of pbrt-v3's derivatives: its hyperboloid is swept by its line only up to
/// rounding.
Parametrization revolved_chart(const Revolved& s, const Vec3& local) {
    Parametrization at = chart(s, local);
    const Vec3 normal = unit_vector(gradient(s.profile, local));
    at.dpdv -= at.dpdv.dot(normal) * normal;
    return at;
}

/// The form at the point is off zero by twice the error bound: half of it as computed, half by
/// rounding. So the surface is no further away than that divided by the gradient's length in world
/// space. The result is doubled, so that the kernel sees the difference. pbrt-v3's normal is that
/// of its derivatives; on a hyperboloid that its line does not sweep it differs from the surface's.
SurfacePoint surface(const Geometry&, const Revolved& s, const RayQuery& q, double t) {
    const Affine& m = s.to_world;
    const Vec3 local = local_point(s, q.ray.origin - m.origin + t * q.ray.direction);
    const Vec3 slope = s.frame.normal(gradient(s.profile, local)), normal = unit_vector(slope);
    const Vec3 position = m.point(local);
    const Vec3 magnitude = abs(m.origin) + std::abs(local.x) * abs(m.x) +
                           std::abs(local.y) * abs(m.y) + std::abs(local.z) * abs(m.z);
    const double off = 2 * form_at(s.profile, local).error / max_abs(slope);
    const Vec3 error = position_error(magnitude, 0) + Vec3(2 * off);
    Vec3 shading_normal = normal;
    if (s.profile.along == Profile::Along::line) {
        const Parametrization at = chart(s, local);
        const Vec3 across = s.frame.normal(at.dpdu.cross(at.dpdv));
        if (max_abs(across) > 0) shading_normal = unit_vector(across);
        if (shading_normal.dot(normal) < 0) shading_normal = -shading_normal;
    }
    return {position, error, normal, shading_normal};
}

Parametrization parametrization(const Geometry&, const Revolved& s, const SurfacePoint& p) {
    const Vec3 local = s.frame.vector(p.position - s.to_world.origin);
    return image(s.to_world, revolved_chart(s, local));
}

}  // namespace etalon
