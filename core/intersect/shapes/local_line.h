// A line in the coordinates of a shape that is the image of the unit sphere or cylinder, in plain
// double beside what every rounding on the way may have done.
#pragma once

#include "core/intersect/shapes/roots.h"
#include "core/numerics/rounding.h"

namespace etalon {

/// A number, and how far it may be from the truth.
struct Approximate {
    double value, error;
};

/// t, if it is good to half of t_tolerance; no_hit where it surely is not beyond tmin; or in_doubt.
inline double ahead(const Approximate& t, double tmin) {
    if (t.value + t.error <= tmin) return no_hit;
    if (!(t.error <= t_tolerance / 2 * std::abs(t.value))) return in_doubt;
    return is_ahead(t.value, tmin) ? t.value : no_hit;
}

/// The point w + t d as the rows of the inverse give it. A difference, a row and a dot product put
/// the origin's coordinates off by 1 + 3 + 3 roundings of |row| |origin|, the direction's by one
/// less; these bounds leave room for a dot or cross product of the two, another 3.
struct LocalLine {
    LocalLine(const Affine& map, const LinearInverse& inverse, const Ray& ray)
        : LocalLine(inverse, ray.origin - map.origin, ray.direction) {}

    /// The error of coordinates from rows that are together no longer than `rows`.
    double error_of_w(double rows) const { return 8 * unit_roundoff * rows * distance; }
    double error_of_d(double rows) const { return 10 * unit_roundoff * rows * speed; }

    /// So that nothing underflows that counts, and nothing overflows.
    bool is_in_range(double rows) const {
        const double growth = rows * speed;
        return rows > 0x1p-900 && rows < 0x1p900 && growth > 0x1p-200 && growth < 0x1p200 &&
               rows * distance < 0x1p200;
    }

    Vec3 w, d;
    double distance, speed;  ///< no less than the lengths, in the world

  private:
    LocalLine(const LinearInverse& inverse, const Vec3& from, const Vec3& towards)
        : w(inverse.vector(from)),
          d(inverse.vector(towards)),
          distance(sum_abs(from)),
          speed(sum_abs(towards)) {}
};

/// The line w + t d and the unit sphere about the origin or, where z is 0, the unit circle:
/// |w + t d|^2 - 1 = A t^2 + 2 B t + C. By Lagrange's identity the discriminant is |d|^2 - |m|^2
/// for m = w x d: it does not cancel with distance, for m / |d| is how far the line passes from the
/// centre.
class UnitLine {
  public:
    UnitLine(const Vec3& w, double e_w, const Vec3& d, double e_d)
        : A_(d.dot(d)), B_(w.dot(d)), C_(w.dot(w) - 1) {
        const Vec3 m = w.cross(d);
        const double far = sum_abs(w), fast = sum_abs(d);
        discriminant_ = A_ - m.dot(m);
        e_A_ = e_d * (2 * fast + e_d);
        e_B_ = e_w * fast + e_d * (far + e_w);  // and of m
        e_C_ = e_w * (2 * far + e_w) + 4 * unit_roundoff * (std::abs(C_) + 2);
        e_discriminant_ = e_A_ + e_B_ * (4 * sum_abs(m) + e_B_);
    }

    /// Outside, and on its way out.
    bool leaves() const { return C_ > e_C_ && B_ > e_B_; }

    bool misses() const { return discriminant_ < -e_discriminant_; }
    bool is_certain() const { return discriminant_ > e_discriminant_; }

    /// By the sum of like signs, in which nothing cancels.
    struct Roots {
        Approximate entry, exit;
    };
    Roots roots() const {
        const double root = std::sqrt(discriminant_), sum = std::abs(B_) + root;
        const double off = (e_B_ + e_discriminant_ / root) / sum + 4 * unit_roundoff;
        const double off_A = e_A_ / A_;
        // To the first order; what the higher ones add is less than a quarter of it.
        const bool small = std::max(off, off_A) < 0.1;
        const double far = sum / A_, near = C_ / sum, more = small ? 1.25 : infinity;
        const double e_far = more * (off + off_A) * far;
        const double e_near = more * (off * std::abs(near) + e_C_ / sum);
        if (B_ < 0) return {{near, e_near}, {far, e_far}};
        return {{-far, e_far}, {-near, e_near}};
    }

  private:
    double A_, B_, C_, discriminant_;
    double e_A_, e_B_, e_C_, e_discriminant_;
};

}  // namespace etalon
