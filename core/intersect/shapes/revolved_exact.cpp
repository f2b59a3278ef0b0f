#include "core/intersect/shapes/revolved_exact.h"

#include "core/intersect/shapes/exact_line.h"
#include "core/intersect/shapes/exact_quadratic.h"

namespace etalon {
namespace {

/// The polynomial a t^2 + b t + c.
struct Polynomial {
    Dyadic a, b, c;
};

/// Components perpendicular to z of a vector that moves along the line, times the determinant: at +
/// t step.
struct MovingVec2 {
    std::array<Dyadic, 2> at, step;
};

MovingVec2 point_on(const ExactLine& line) {
    return {{line.w[0], line.w[1]}, {line.d[0], line.d[1]}};
}

/// Returns the direction at the height of the line's point.
MovingVec2 along(const TurningDirection& direction, const ExactLine& line) {
    const auto component = [&](double at, double per_height) {
        return std::pair(Dyadic(at) * line.unit + Dyadic(per_height) * line.w[2],
                         Dyadic(per_height) * line.d[2]);
    };
    const auto [x, dx] = component(direction.at.x, direction.per_height.x);
    const auto [y, dy] = component(direction.at.y, direction.per_height.y);
    return {{x, y}, {dx, dy}};
}

using Pair = std::array<Dyadic, 2>;

Dyadic cross(const Pair& a, const Pair& b) {
    return a[0] * b[1] - a[1] * b[0];
}

Polynomial cross(const MovingVec2& a, const MovingVec2& b) {
    return {cross(a.step, b.step), cross(a.at, b.step) + cross(a.step, b.at), cross(a.at, b.at)};
}

/// Intersection of a line and the surface, in local coordinates times the determinant.
class ExactRevolved {
  public:
    ExactRevolved(const Revolved& s, const Ray& ray)
        : surface_(s), line_(s.to_world, ray), form_(form()) {}

    /// Returns the first visible t. Both roots of a tangent are its one point, which shows both
    /// sides.
    double first_hit(Sides sides, double tmin) const {
        if (!form_.has_roots()) return no_hit;
        const int first = form_.opening() < 0 ? out : in;
        for (const int way : {first, -first}) {
            const bool hidden = sides == (way == in ? Sides::back : Sides::front);
            const double t = form_.root(way);
            if (!hidden && is_ahead(t, tmin) && is_within_curve(way) && is_in_sector(way)) return t;
        }
        return no_hit;
    }

  private:
    static constexpr int in = ExactQuadratic::in, out = ExactQuadratic::out;

    /// Returns the form that vanishes on the surface and is positive on its front; for a plane,
    /// twice the height over it.
    ExactQuadratic form() const {
        const auto& [w, d, unit] = line_;
        if (surface_.profile.is_flat()) return {Dyadic(), d[2], w[2] + w[2]};
        const auto& q = surface_.profile.squares;
        const Dyadic q0(q[0]), half_q1(0.5 * q[1]), q2(q[2]),
            steepness = half_q1 * unit + q2 * w[2];
        return {
            square(d[0]) + square(d[1]) - q2 * square(d[2]),
            w[0] * d[0] + w[1] * d[1] - steepness * d[2],
            square(w[0]) + square(w[1]) - q0 * square(unit) - (half_q1 * unit + steepness) * w[2]};
    }

    bool is_within_curve(int way) const {
        const auto& [w, d, unit] = line_;
        const Dyadic low(surface_.profile.low), high(surface_.profile.high);
        if (!surface_.profile.is_flat()) {
            return form_.sign_at_root(way, w[2] - low * unit, d[2]) >= 0 &&
                   form_.sign_at_root(way, w[2] - high * unit, d[2]) <= 0;
        }
        const Dyadic a = square(d[0]) + square(d[1]), half_b = w[0] * d[0] + w[1] * d[1];
        const auto side = [&, w = w, unit = unit](const Dyadic& radius) {
            const Dyadic c = square(w[0]) + square(w[1]) - square(radius * unit);
            return form_.sign_at_root(way, a, half_b + half_b, c);
        };
        return side(low) >= 0 && side(high) <= 0;
    }

    bool is_in_sector(int way) const {
        const Sector& sector = surface_.sector;
        if (sector.is_whole) return true;
        const MovingVec2 point = point_on(line_);
        const auto side = [&](const Polynomial& p) {
            return form_.sign_at_root(way, p.a, p.b, p.c) >= 0;
        };
        const bool after = side(cross(along(sector.from, line_), point));
        if (after != sector.is_convex) return after;
        return side(cross(point, along(sector.to, line_)));
    }

    const Revolved& surface_;
    const ExactLine line_;
    const ExactQuadratic form_;
};

}  // namespace

double exact_first_hit(const Revolved& s, Sides sides, const Ray& ray) {
    if (!s.exists() || !is_finite(ray.origin) || !is_finite(ray.direction)) return no_hit;
    return ExactRevolved(s, ray).first_hit(sides, ray.tmin);
}

}  // namespace etalon
