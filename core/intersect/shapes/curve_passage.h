// Passage of a ray by a curve: code that all kernels of a curve share.
#pragma once

#include <cmath>
#include <numbers>

#include "core/intersect/shapes/curve_ray.h"

namespace etalon {

/// Returns the normal of a ribbon, interpolated on the arc between those at its ends. As in pbrt-v3
/// it is not quite a unit vector where they are more than a quarter turn apart.
inline Vec3 ribbon_normal(const BezierCurve& c, double u) {
    const Vec3 a(c.normals[0]), b(c.normals[1]);
    const double angle = std::acos(std::clamp(a.dot(b), 0.0, 1.0)), sine = std::sin(angle);
    if (!(sine > 0)) return a;
    return (std::sin((1 - u) * angle) / sine) * a + (std::sin(u * angle) / sine) * b;
}

/// Point at which a ray passes a curve.
struct CurvePassage {
    double t;
    double u, v;
    double width;  ///< as the ray sees it
    double x, y;   ///< the curve's point, seen from the ray: along and across the line of sight
};

/// The axes along which a ray sees a curve: z is the ray's direction, and x is as close to the
/// curve's as possible, so that y is small.
class CurveView {
  public:
    CurveView(const CurveRay& ray, const CubicPoints& part)
        : origin_(ray.origin), start_(ray.start) {
        const double length = std::sqrt(ray.direction.dot(ray.direction));
        z = ray.direction / length;
        per_length_ = ray.scale / length;
        const Vec3 chord = part[3] - part[0], across = z.cross(chord);
        const double reach2 = across.dot(across);
        y = across / std::sqrt(reach2);
        if (!(reach2 > 0) || !is_finite(y)) orthonormal_basis(z, x, y);
        x = y.cross(z);
    }

    /// Returns a point relative to the ray's start, in these axes.
    Vec3 point(const Vec3& p) const {
        const Vec3 w = p - origin_;
        return {x.dot(w), y.dot(w), z.dot(w)};
    }

    double t_at(double depth) const { return start_ + depth * per_length_; }
    double depth_of_origin() const { return -start_ / per_length_; }

    Vec3 x, y, z;

  private:
    Vec3 origin_;
    double start_, per_length_;
};

/// Calls take(passage) for each piece of the part that the ray's line passes, beyond its origin.
template <class Take>
class CurvePassages {
  public:
    CurvePassages(const StoredCurve& c, const CubicPoints& part, const CurveView& view,
                  const Take& take)
        : c_(c), part_(part), view_(view), take_(take) {}

    void find() const {
        CubicPoints seen;
        for (std::size_t i = 0; i < 4; ++i) seen[i] = view_.point(part_[i]);
        const double begin = c_.part.begin(), end = c_.part.end();
        if (may_pass(seen.data(), begin, end)) halve(seen, begin, end, depth_for(seen));
    }

  private:
    /// Returns whether the box of the control points, widened by half the width, contains a point
    /// of the ray.
    bool may_pass(const Vec3* p, double begin, double end) const {
        const double half = 0.5 * widest(c_.curve, begin, end);
        const auto low = [p](int k) {
            return std::min(std::min(p[0][k], p[1][k]), std::min(p[2][k], p[3][k]));
        };
        const auto high = [p](int k) {
            return std::max(std::max(p[0][k], p[1][k]), std::max(p[2][k], p[3][k]));
        };
        return low(1) <= half && high(1) >= -half && low(0) <= half && high(0) >= -half &&
               high(2) >= view_.depth_of_origin() - half;
    }

    /// Returns how often to halve the curve. Each halving quarters the bend; a piece may be off its
    /// chord by about a twentieth of the width. This is pbrt-v3's formula, with its rounding.
    int depth_for(const CubicPoints& p) const {
        double bend = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            bend = std::max(bend, max_abs(p[i] - 2.0 * p[i + 1] + p[i + 2]));
        }
        const double allowed =
            0.05 * std::max(std::abs(c_.curve.widths[0]), std::abs(c_.curve.widths[1]));
        const double ratio = std::min(std::numbers::sqrt2 * 6 / 8 * bend / allowed, 0x1p40);
        if (!(ratio >= 1)) return 0;
        const int nearest_logarithm = std::ilogb(ratio * (4.0 / 3));
        return std::min(nearest_logarithm / 2, 10);
    }

    void halve(const CubicPoints& p, double begin, double end, int depth) const {
        if (depth == 0) return pass(p, begin, end);
        const std::array<Vec3, 7> both = halves_of(p);
        const double middle = 0.5 * (begin + end);
        if (may_pass(&both[0], begin, middle)) {
            halve({both[0], both[1], both[2], both[3]}, begin, middle, depth - 1);
        }
        if (may_pass(&both[3], middle, end)) {
            halve({both[3], both[4], both[5], both[6]}, middle, end, depth - 1);
        }
    }

    /// Intersects a piece that is taken as straight. It ends perpendicular to its tangents, where
    /// the next one begins.
    void pass(const CubicPoints& p, double begin, double end) const {
        if (beyond(p[0], p[1]) || beyond(p[3], p[2])) return;
        const double along_x = p[3].x - p[0].x, along_y = p[3].y - p[0].y;
        const double length2 = along_x * along_x + along_y * along_y;
        const double w = -(p[0].x * along_x + p[0].y * along_y) / length2;
        if (!std::isfinite(w)) return;
        const double part = std::clamp(w, 0.0, 1.0);
        const Vec3 at = blossom(p, part, part, part);
        CurvePassage passage{view_.t_at(at.z), (1 - part) * begin + part * end, 0, 0, at.x, at.y};
        passage.width = seen_width(passage.u);
        const double distance2 = at.x * at.x + at.y * at.y, half = 0.5 * passage.width;
        if (!(distance2 <= half * half) || !(half > 0)) return;
        const Vec3 tangent = derivative_of(p, part);
        const double side = at.x * tangent.y - at.y * tangent.x > 0 ? 0.5 : -0.5;
        passage.v = 0.5 + side * std::min(1.0, std::sqrt(distance2) / half);
        take_(passage);
    }

    /// Returns whether the ray passes on the other side of an end than the rest of the piece.
    static bool beyond(const Vec3& end, const Vec3& next) {
        return (next.y - end.y) * -end.y + end.x * (end.x - next.x) < 0;
    }

    double seen_width(double u) const {
        const double width = std::abs(width_at(c_.curve, u));
        if (c_.curve.type != CurveType::ribbon) return width;
        return width * std::abs(ribbon_normal(c_.curve, u).dot(view_.z));
    }

    const StoredCurve& c_;
    const CubicPoints& part_;
    const CurveView& view_;
    const Take& take_;
};

}  // namespace etalon
