// A ray in the space of a curve.
#pragma once

#include <cmath>

#include "core/intersect/ray.h"
#include "core/numerics/rounding.h"
#include "core/scene/bezier.h"
#include "core/scene/curve_list.h"

namespace etalon {

inline CubicPoints points_of(const BezierCurve& c) {
    return {Vec3(c.points[0]), Vec3(c.points[1]), Vec3(c.points[2]), Vec3(c.points[3])};
}

/// Returns the control points of the part.
inline CubicPoints part_points(const StoredCurve& c) {
    return part_of(points_of(c.curve), c.part.begin(), c.part.end());
}

inline double width_at(const BezierCurve& c, double u) {
    return (1 - u) * c.widths[0] + u * c.widths[1];
}

/// Returns the largest width of a part; the width is linear.
inline double widest(const BezierCurve& c, double begin, double end) {
    return std::max(std::abs(width_at(c, begin)), std::abs(width_at(c, end)));
}

/// Stretch below which the roundings of a ray from far away are as small as those of its own
/// coordinates.
inline constexpr double ample_stretch = 16;

/// Distance, relative to the size of what is seen, below which its roundings are negligible.
inline constexpr double ample_distance = 0x1p16;

/// A ray in a curve's space: t is `start` plus multiples of the direction times `scale`.
struct CurveRay {
    CurveRay(const StoredCurve& c, const CubicPoints& part, const Ray& ray)
        : origin(start_near(c, part, ray)) {
        const Vec3 d = c.place.vector(ray.direction);
        scale = power_of_two_reciprocal(max_abs(d));
        direction = d * scale;
    }

    /// Returns whether the ray's line surely passes all control points of the part on one side, by
    /// more than `half` a width. Most rays whose kernels are called do, and need no view of the
    /// curve.
    ///
    /// The distance is that from the plane of the line and the chord. For lines at an angle of
    /// 2^-18 or more, |across| > 2^-18 |chord|, the roundings of the plane's normal are below 2^-30
    /// of its length; so are those of CurveView::y, along which the kernel looks. The product of
    /// two lengths is at most three times that of the largest components, so that the roundings of
    /// both, 2^-29, are below `roundings`.
    bool passes_beside(const CubicPoints& part, double half) const {
        const Vec3 chord = part[3] - part[0], across = direction.cross(chord);
        const double across2 = across.dot(across);
        if (!(across2 > 0x1p-36 * chord.dot(chord)) || !(across2 > 0x1p-900)) return false;
        double low = infinity, high = -infinity, furthest = 0;
        for (const Vec3& p : part) {
            const Vec3 w = p - origin;
            const double distance = across.dot(w);
            low = std::min(low, distance);
            high = std::max(high, distance);
            furthest = std::max(furthest, max_abs(w));
        }
        const double roundings = 0x1p-27 * max_abs(across) * furthest;
        const double room = std::max(low, -high) - roundings;
        return room > 0 && room * room * (1 - 0x1p-40) > across2 * half * half;
    }

    double start = 0;  ///< t of the origin; declared first, as finding the origin moves it
    Vec3 origin;       ///< a point of the ray near the curve
    Vec3 direction;    ///< of a largest component from 1 to 2
    double scale;      ///< of t for the direction

  private:
    /// Returns where the ray starts in the curve's space. The start is moved to the point nearest
    /// to the map's origin if the map's axes differ so much that the roundings of a far origin
    /// would be longer than the curve, or if the ray comes from that far. Then its own roundings
    /// move the point along each axis only by those of the ray's part along it, for which boxes of
    /// instances have room. The second step corrects what the rounding of t left over in the first.
    Vec3 start_near(const StoredCurve& c, const CubicPoints& part, const Ray& ray) {
        Vec3 near = ray.origin - c.place.to_world.origin;
        if (c.place.stretch > ample_stretch) advance(near, ray);
        double size = widest(c.curve, c.part.begin(), c.part.end());
        for (const Vec3& p : part) size = std::max(size, max_abs(p));
        Vec3 seen = c.place.vector(near);
        for (int step = 0; step < 2 && max_abs(seen) > ample_distance * size; ++step) {
            advance(near, ray);
            seen = c.place.vector(near);
        }
        return seen;
    }

    /// Moves a point of the ray to the place where it is nearest to 0.
    void advance(Vec3& point, const Ray& ray) {
        const double shrink = power_of_two_reciprocal(max_abs(ray.direction));
        const Vec3 d = ray.direction * shrink;
        const double step = -point.dot(d) / d.dot(d) * shrink;
        point += step * ray.direction;
        start += step;
    }
};

}  // namespace etalon
