#include "core/oracle/define.h"
#include "core/oracle/mapped_ray.h"
#include "core/oracle/quadratic.h"

namespace etalon::definition {
namespace {

struct TrackedVec2 {
    Tracked x, y;
};

Tracked cross(const TrackedVec2& a, const TrackedVec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// A direction at the height z / unit, times unit.
TrackedVec2 at_height(const TurningDirection& d, const Tracked& z, const Tracked& unit) {
    return {Tracked(d.at.x) * unit + Tracked(d.per_height.x) * z,
            Tracked(d.at.y) * unit + Tracked(d.per_height.y) * z};
}

/// Returns whether a point, given times `unit` > 0, is within the sector, its ends included.
Certainty is_within(const Sector& sector, const TrackedVec& p, const Tracked& unit) {
    if (sector.is_whole) return Certainty::yes;
    const TrackedVec2 across{p.x, p.y};
    const Certainty after = !is_negative(cross(at_height(sector.from, p.z, unit), across)),
                    before = !is_negative(cross(across, at_height(sector.to, p.z, unit)));
    return sector.is_convex ? after & before : after | before;
}

/// Returns whether a point, given times `unit` > 0, is within the ends of the curve.
Certainty is_within(const Profile& profile, const TrackedVec& p, const Tracked& unit) {
    const Tracked low = Tracked(profile.low) * unit, high = Tracked(profile.high) * unit;
    if (!profile.is_flat()) return (low <= p.z) & (p.z <= high);
    const Tracked radius2 = p.x * p.x + p.y * p.y;
    return (low * low <= radius2) & (radius2 <= high * high);
}

Roots meet_curve(const Profile& profile, const TrackedVec& o, const TrackedVec& d,
                 const Tracked& unit) {
    const Tracked q0 = profile.squares[0], q1 = profile.squares[1], q2 = profile.squares[2];
    return solve(d.x * d.x + d.y * d.y - q2 * (d.z * d.z),
                 o.x * d.x + o.y * d.y - q2 * (o.z * d.z) - Tracked(0.5) * q1 * (d.z * unit),
                 o.x * o.x + o.y * o.y - q2 * (o.z * o.z) - q1 * (o.z * unit) - q0 * (unit * unit));
}

/// Returns the one point of a line in the plane z = 0.
Roots meet_plane(const TrackedVec& o, const TrackedVec& d) {
    Roots roots;
    if (is_zero(d.z) == Certainty::yes) return roots;
    roots.list[roots.count++] = {-o.z / d.z, !is_zero(d.z), is_negative(d.z)};
    return roots;
}

}  // namespace

/// Solves x^2 + y^2 = q0 + q1 z + q2 z^2, or z = 0, in the map's coordinates, then clips at o + t
/// d.
Crossings define(const Geometry&, const Revolved& s, const Ray& ray) {
    Crossings found;
    if (!s.exists()) return found;
    MappedRay r(s.to_world, ray);
    const Certainty exists = !is_zero(r.unit);
    if (r.unit.value < 0) {
        r.unit = -r.unit;
        r.origin = TrackedVec() - r.origin;
        r.direction = TrackedVec() - r.direction;
    }
    const TrackedVec &o = r.origin, &d = r.direction;
    const Roots roots =
        s.profile.is_flat() ? meet_plane(o, d) : meet_curve(s.profile, o, d, r.unit);
    for (std::size_t i = 0; i < roots.count; ++i) {
        const Root& root = roots.list[i];
        const TrackedVec p{o.x + root.t * d.x, o.y + root.t * d.y, o.z + root.t * d.z};
        const Certainty within = is_within(s.profile, p, r.unit) & is_within(s.sector, p, r.unit);
        found.add({root.t, exists & root.exists & within, root.falling});
    }
    return found;
}

}  // namespace etalon::definition
