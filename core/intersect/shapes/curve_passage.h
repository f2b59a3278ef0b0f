// Passage of a ray by a curve: code that all kernels of a curve share.
#pragma once

#include <cmath>
#include <numbers>

#include "core/intersect/ray.h"
#include "core/numerics/rounding.h"
#include "core/scene/bezier.h"
#include "core/scene/curve_list.h"
#include "core/scene/map_condition.h"

namespace etalon {

inline CubicPoints points_of(const BezierCurve& c) {
    return {Vec3(c.points[0]), Vec3(c.points[1]), Vec3(c.points[2]), Vec3(c.points[3])};
}

inline double width_at(const BezierCurve& c, double u) {
    return (1 - u) * c.widths[0] + u * c.widths[1];
}

/// Returns the largest width of a part; the width is linear.
inline double widest(const BezierCurve& c, double begin, double end) {
    return std::max(std::abs(width_at(c, begin)), std::abs(width_at(c, end)));
}

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

/// Stretch below which the roundings of a ray from far away are as small as those of its own
/// coordinates.
inline constexpr double ample_stretch = 16;

/// Distance, relative to the size of what is seen, below which its roundings are negligible.
inline constexpr double ample_distance = 0x1p16;

/// A ray in a curve's space, and the axes along which the curve is seen: z is the ray's direction,
/// and x is as close to the curve's as possible, so that y is small.
class CurveView {
  public:
    CurveView(const StoredCurve& c, const CubicPoints& part, const Ray& ray) {
        origin_ = start_near(c, part, ray);
        const Vec3 d = c.place.vector(ray.direction);
        const double scale = power_of_two_reciprocal(max_abs(d));
        const Vec3 scaled = d * scale;
        const double length = std::sqrt(scaled.dot(scaled));
        z = scaled / length;
        per_length_ = scale / length;
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
    /// Returns where the ray starts in the curve's space. The start is moved to the point nearest
    /// to the map's origin if the map's axes differ so much that the roundings of a far origin
    /// would be longer than the curve, or if the ray comes from that far. Then its own roundings
    /// move the point along each axis only by those of the ray's part along it, for which boxes of
    /// instances have room. The second step corrects what the rounding of t left over in the first.
    Vec3 start_near(const StoredCurve& c, const CubicPoints& part, const Ray& ray) {
        Vec3 origin = ray.origin - c.place.to_world.origin;
        if (stretch_of(c.place.to_world, c.place.rows) > ample_stretch) advance(origin, ray);
        double size = widest(c.curve, c.part.begin(), c.part.end());
        for (const Vec3& p : part) size = std::max(size, max_abs(p));
        for (int step = 0; step < 2; ++step) {
            if (max_abs(c.place.vector(origin)) > ample_distance * size) advance(origin, ray);
        }
        return c.place.vector(origin);
    }

    /// Moves a point of the ray to the place where it is nearest to 0.
    void advance(Vec3& origin, const Ray& ray) {
        const double scale = power_of_two_reciprocal(max_abs(ray.direction));
        const Vec3 d = ray.direction * scale;
        const double step = -origin.dot(d) / d.dot(d) * scale;
        origin += step * ray.direction;
        start_ += step;
    }

    Vec3 origin_;
    double start_ = 0, per_length_;
};

/// Calls take(passage) for each piece of the part that the ray's line passes, beyond its origin.
template <class Take>
class CurvePassages {
  public:
    CurvePassages(const StoredCurve& c, const Ray& ray, const Take& take)
        : c_(c),
          part_(part_of(points_of(c.curve), c.part.begin(), c.part.end())),
          view_(c, part_, ray),
          take_(take) {}

    void find() const {
        CubicPoints seen;
        for (std::size_t i = 0; i < 4; ++i) seen[i] = view_.point(part_[i]);
        const double begin = c_.part.begin(), end = c_.part.end();
        if (may_pass(seen.data(), begin, end)) halve(seen, begin, end, depth_for(seen));
    }

    const CurveView& view() const { return view_; }

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
    CubicPoints part_;
    CurveView view_;
    const Take& take_;
};

}  // namespace etalon
