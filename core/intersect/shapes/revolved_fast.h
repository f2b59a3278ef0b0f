// Fast path for most rays on a surface of revolution, in plain double with a bound on all rounding
// errors. What it leaves uncertain is decided by core/intersect/shapes/revolved_exact.h.
#pragma once

#include "core/intersect/shapes/approximate_roots.h"
#include "core/scene/revolved.h"

namespace etalon {

/// Arithmetic on numbers with error bounds, including its own roundings.
inline Approximate operator+(const Approximate& a, const Approximate& b) {
    const double sum = a.value + b.value;
    return {sum, a.error + b.error + 1.01 * unit_roundoff * std::abs(sum)};
}
inline Approximate operator-(const Approximate& a, const Approximate& b) {
    return a + Approximate{-b.value, b.error};
}
inline Approximate operator*(const Approximate& a, const Approximate& b) {
    const double product = a.value * b.value;
    return {product, std::abs(a.value) * b.error + (std::abs(b.value) + b.error) * a.error +
                         1.01 * unit_roundoff * std::abs(product)};
}
inline Approximate exactly_known(double x) {
    return {x, 0};
}

/// The line in local coordinates, from its point nearest to the middle of the surface, so that its
/// error grows with distance and not with the square of distance.
class RevolvedFastPath {
  public:
    RevolvedFastPath(const Revolved& s, const RayQuery& q)
        : surface_(s), tmin_(q.ray.tmin), line_(s.to_world.origin, s.frame, q.ray) {}

    /// Returns the first visible t beyond tmin, good to t_tolerance; no_hit; or uncertain.
    double first_hit(Sides sides) {
        const LocalFrame& frame = surface_.frame;
        for (int k = 0; k < 3; ++k) {
            if (!line_.is_in_range(frame.length(k))) return uncertain;
        }
        advance();
        return surface_.profile.is_flat() ? on_plane(sides) : on_curve(sides);
    }

  private:
    static constexpr double u = unit_roundoff;

    /// Returns the height of the point that the start is to be near: the middle of the surface, or
    /// what a cone has nearest to its apex, the origin, about which no root's terms cancel.
    double height_to_start_at() const {
        const Profile& p = surface_.profile;
        if (p.is_flat()) return 0;
        const bool is_cone = p.squares[0] == 0 && p.squares[1] == 0;
        return is_cone ? std::clamp(0.0, p.low, p.high) : 0.5 * (p.low + p.high);
    }

    /// Moves the start near the surface, with errors of start and direction.
    void advance() {
        const Vec3 &w = line_.w, &d = line_.d;
        const double towards = -(w.x * d.x + w.y * d.y + (w.z - height_to_start_at()) * d.z);
        start_ = std::max(0.0, towards / d.dot(d));
        if (!(start_ < infinity)) start_ = 0;
        for (int k = 0; k < 3; ++k) {
            const double row = surface_.frame.length(k);
            d_[k] = {d[k], line_.error_of_d(row)};
            w_[k] = Approximate{w[k], line_.error_of_w(row)} + exactly_known(start_) * d_[k];
        }
    }

    double on_plane(Sides sides) const {
        const int way = d_[2].value < 0 ? -1 : 1;
        const double speed = std::abs(d_[2].value) - d_[2].error;
        if (!(speed > 0.5 * std::abs(d_[2].value))) return uncertain;
        const double t = -w_[2].value / d_[2].value;
        const double error = (w_[2].error + std::abs(t) * d_[2].error) / speed;
        return visible({t, 1.01 * (error + 2 * u * std::abs(t))}, way, sides);
    }

    /// Intersects the form x^2 + y^2 - squares(z) with the line: see Profile.
    double on_curve(Sides sides) const {
        const auto& [x, y, z] = w_;
        const auto& [dx, dy, dz] = d_;
        const auto& q = surface_.profile.squares;
        const Approximate q0 = exactly_known(q[0]), half_q1 = exactly_known(0.5 * q[1]),
                          q2 = exactly_known(q[2]), steepness = half_q1 + q2 * z;
        ApproximateRoots roots(dx * dx + dy * dy - q2 * dz * dz, x * dx + y * dy - steepness * dz,
                               x * x + y * y - (q0 + (half_q1 + steepness) * z));
        if (roots.misses()) return no_hit;
        if (!roots.is_certain()) return uncertain;
        roots.solve();
        const int way = roots.near_way();
        const Approximate near = roots.near();
        if (roots.has_one_within(stretch())) return visible(near, way, sides);
        if (!roots.has_two()) return uncertain;
        const Approximate far = roots.far();
        const bool in_order = near.value < far.value;
        const double first = visible(in_order ? near : far, in_order ? way : -way, sides);
        if (!std::isnan(first)) return first;
        return visible(in_order ? far : near, in_order ? -way : way, sides);
    }

    /// Returns how far along the line from the start the surface may be.
    double stretch() const {
        const Profile& p = surface_.profile;
        const double height = std::max(std::abs(p.low), std::abs(p.high));
        const double radius =
            std::sqrt(std::abs(p.squares[0]) +
                      height * (std::abs(p.squares[1]) + height * std::abs(p.squares[2])));
        double away = height + radius, speed = 0;
        for (int k = 0; k < 3; ++k) {
            away += std::abs(w_[k].value) + w_[k].error;
            speed = std::max(speed, std::abs(d_[k].value) - d_[k].error);
        }
        return 1.01 * away / speed;
    }

    /// Returns the t of a point on the curve if it is visible, not clipped and beyond tmin.
    double visible(const Approximate& from_start, int way, Sides sides) const {
        if (sides == (way < 0 ? Sides::back : Sides::front)) return no_hit;
        const Approximate t = exactly_known(start_) + from_start;
        if (t.value + t.error < tmin_) return no_hit;
        // Exact arithmetic knows t much better here.
        if (surface_.is_sheared && t.error > 0x1p-48 * std::abs(t.value)) return uncertain;
        const Certain within = is_within(from_start);
        if (within == Certain::no) return no_hit;
        return within == Certain::yes ? ahead(t, tmin_) : uncertain;
    }

    enum class Certain { no, unknown, yes };

    static Certain is_positive(const Approximate& x) {
        const double error = 1.01 * x.error;  // with room for its own roundings
        if (x.value > error) return Certain::yes;
        return x.value < -error ? Certain::no : Certain::unknown;
    }
    static Certain both(Certain a, Certain b) { return std::min(a, b); }
    static Certain is_between(const Approximate& x, const Approximate& a, const Approximate& b) {
        return both(is_positive(x - a), is_positive(b - x));
    }

    Certain is_within(const Approximate& t) const {
        if (!(t.error < infinity)) return Certain::unknown;
        const Approximate x = w_[0] + t * d_[0], y = w_[1] + t * d_[1], z = w_[2] + t * d_[2];
        const Profile& p = surface_.profile;
        const Approximate low = exactly_known(p.low), high = exactly_known(p.high);
        const Certain on_curve = !p.is_flat() ? is_between(z, low, high)
                                 : p.low == 0 ? is_positive(high * high - (x * x + y * y))
                                              : is_between(x * x + y * y, low * low, high * high);
        if (on_curve == Certain::no || surface_.sector.is_whole) return on_curve;
        return both(on_curve, is_in_sector(x, y, z));
    }

    /// Returns the sign of the direction at the height z times (x, y).
    static Certain is_after(const TurningDirection& from, const Approximate& x,
                            const Approximate& y, const Approximate& z) {
        const auto at = [&](double constant, double per_height) {
            return per_height == 0 ? exactly_known(constant)
                                   : exactly_known(constant) + exactly_known(per_height) * z;
        };
        return is_positive(at(from.at.x, from.per_height.x) * y -
                           at(from.at.y, from.per_height.y) * x);
    }

    Certain is_in_sector(const Approximate& x, const Approximate& y, const Approximate& z) const {
        const Sector& sector = surface_.sector;
        const Approximate minus_x{-x.value, x.error}, minus_y{-y.value, y.error};
        const Certain after = is_after(sector.from, x, y, z),
                      before = is_after(sector.to, minus_x, minus_y, z);
        return sector.is_convex ? std::min(after, before) : std::max(after, before);
    }

    const Revolved& surface_;
    const double tmin_;
    const LocalLine line_;
    double start_ = 0;
    std::array<Approximate, 3> w_, d_;
};

}  // namespace etalon
