// A line in the coordinates of a shape that is the image of a unit shape, in plain double with
// bounds on the rounding errors.
#pragma once

#include "core/intersect/shapes/roots.h"
#include "core/numerics/local_frame.h"
#include "core/numerics/rounding.h"

namespace etalon {

/// A number with a bound on its error.
struct Approximate {
    double value, error;
};

/// Returns t if it is good to half of t_tolerance; no_hit if it surely is not beyond tmin;
/// otherwise uncertain.
inline double ahead(const Approximate& t, double tmin) {
    if (t.value + t.error <= tmin) return no_hit;
    if (!(t.error <= t_tolerance / 2 * std::abs(t.value))) return uncertain;
    return is_ahead(t.value, tmin) ? t.value : no_hit;
}

/// The interval of a line inside a solid.
struct LineInterval {
    Approximate entry, exit;
};

/// Returns the first visible end of the interval beyond tmin; no_hit; or uncertain.
inline double first_ahead(const LineInterval& s, Sides sides, double tmin) {
    const double entry = sides == Sides::back ? no_hit : ahead(s.entry, tmin);
    return entry <= infinity || sides == Sides::front ? entry : ahead(s.exit, tmin);
}

/// A ray's line in a frame, w + t d. A difference, a row and a dot product put w off by 1 + 2 + 3
/// roundings of |row| |origin|, and d by one less. These bounds leave room for a dot or cross
/// product of the two, another 3.
struct LocalLine {
    LocalLine(const Vec3& centre, const LocalFrame& frame, const Ray& ray)
        : LocalLine(frame, ray.origin - centre, ray.direction) {}

    /// Returns the error of coordinates from rows that are together no longer than `rows`.
    double error_of_w(double rows) const { return 8 * unit_roundoff * rows * distance; }
    double error_of_d(double rows) const { return 10 * unit_roundoff * rows * speed; }

    /// Returns whether relevant underflow, and overflow, are excluded.
    bool is_in_range(double rows) const {
        const double growth = rows * speed;
        return rows > 0x1p-400 && rows < 0x1p400 && growth > 0x1p-200 && growth < 0x1p200 &&
               rows * distance < 0x1p200;
    }

    Vec3 w, d;
    double distance;  ///< in world space; infinite, and so out of range, if its square underflows
    double speed;     ///< at least the length of the direction, in world space

  private:
    static double length_in_range(const Vec3& v) {
        const double square = v.dot(v);
        return square > 0x1p-900 || v == Vec3(0) ? std::sqrt(square) : infinity;
    }

    LocalLine(const LocalFrame& frame, const Vec3& from, const Vec3& towards)
        : w(frame.vector(from)),
          d(frame.vector(towards)),
          distance(length_in_range(from)),
          speed(sum_abs(towards)) {}
};

}  // namespace etalon
