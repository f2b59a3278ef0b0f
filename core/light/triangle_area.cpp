#include "core/light/triangle_area.h"

#include <algorithm>

#include "core/light/spherical_triangle.h"

namespace etalon {
namespace {

/// Returns whether a shape is so near for its size that sampling its solid angle instead of its
/// area pays.
bool is_near(const Vec3& from, const Vec3& centre, double area) {
    return area > 0.1 * (centre - from).length2();
}

/// Returns whether the angles of spherical triangles of that solid angle are good to a few digits,
/// as in pbrt-v4.
bool is_accurate(double solid_angle) {
    return solid_angle > 3e-4 && solid_angle < 6.22;
}

/// Returns a point uniformly distributed over a triangle.
Vec3 point_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec2& uv) {
    const double root = std::sqrt(uv.x);
    return (1 - root) * a + root * (1 - uv.y) * b + root * uv.y * c;
}

/// Returns the point of the plane through `a` in a direction of given density per solid angle.
AreaPoint point_towards(const std::optional<Vec3>& direction, const Vec3& from, const Vec3& a,
                        const Vec3& normal, double pdf) {
    const double approach = direction ? normal.dot(*direction) : 0;
    if (approach == 0) return {a, normal, 0};
    return {from + normal.dot(a - from) / approach * *direction, normal, pdf};
}

Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b - a).cross(c - a) / 2;
}

Vec3 centre_of(const Vec3& a, const Vec3& b, const Vec3& c) {
    return (a + b + c) / 3;
}

BoundingSphere bounds_of(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 centre = centre_of(a, b, c);
    const double radius2 =
        std::max({(a - centre).length2(), (b - centre).length2(), (c - centre).length2()});
    return {centre, std::sqrt(radius2)};
}

/// Two triangles a b c and a c d seen from a point.
struct SeenPair {
    SeenPair(const Vec3& from, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
        : first{normalized(a - from), normalized(b - from), normalized(c - from)},
          second{first.a, first.c, normalized(d - from)},
          first_angle(first.solid_angle()),
          angle(first_angle + second.solid_angle()) {}

    bool is_accurate() const {
        return etalon::is_accurate(first_angle) && etalon::is_accurate(angle - first_angle);
    }

    SphericalTriangle first, second;
    double first_angle, angle;  ///< solid angles of the first, and of both
};

/// Chooses one of two parts with `x` in [0, 1), where the first has `share`, and rescales `x`
/// within it.
bool takes_first(double& x, double share) {
    const bool first = x < share;
    x = first ? x / share : (x - share) / (1 - share);
    return first;
}

}  // namespace

TriangleArea::TriangleArea(const Vec3& a, const Vec3& b, const Vec3& c) : a_(a), b_(b), c_(c) {
    const Vec3 area = area_vector(a, b, c);
    area_ = area.length();
    normal_ = area / area_;
}

BoundingSphere TriangleArea::bounds() const {
    return bounds_of(a_, b_, c_);
}

AreaPoint TriangleArea::sample(const Vec3& from, const Vec2& uv) const {
    if (is_near(from, centre_of(a_, b_, c_), area_)) {
        const SphericalTriangle seen(from, a_, b_, c_);
        const double angle = seen.solid_angle();
        if (is_accurate(angle)) {
            return point_towards(seen.direction(angle, uv), from, a_, normal_, 1 / angle);
        }
    }
    return chosen_by_area(from, point_of(a_, b_, c_, uv), normal_, area_);
}

double TriangleArea::pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const {
    if (is_near(from, centre_of(a_, b_, c_), area_)) {
        const double angle = SphericalTriangle(from, a_, b_, c_).solid_angle();
        if (is_accurate(angle)) return 1 / angle;
    }
    return per_steradian(1 / area_, from, position, normal);
}

TwoTrianglesArea::TwoTrianglesArea(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
    : a_(a), b_(b), c_(c), d_(d) {
    const Vec3 first = area_vector(a, b, c);
    first_area_ = first.length();
    area_ = first_area_ + area_vector(a, c, d).length();
    normal_ = first / first_area_;
}

Vec3 TwoTrianglesArea::centre() const {
    return (centre_of(a_, b_, c_) + centre_of(a_, c_, d_)) / 2;
}

BoundingSphere TwoTrianglesArea::bounds() const {
    const BoundingSphere p = bounds_of(a_, b_, c_), q = bounds_of(a_, c_, d_);
    const double distance = (p.centre - q.centre).length();
    return {centre(), distance / 2 + std::max(p.radius, q.radius)};
}

AreaPoint TwoTrianglesArea::sample(const Vec3& from, const Vec2& uv) const {
    Vec2 place = uv;
    if (is_near(from, centre(), area_)) {
        const SeenPair seen(from, a_, b_, c_, d_);
        if (seen.is_accurate()) {
            const bool first = takes_first(place.x, seen.first_angle / seen.angle);
            const auto direction =
                first ? seen.first.direction(seen.first_angle, place)
                      : seen.second.direction(seen.angle - seen.first_angle, place);
            return point_towards(direction, from, a_, normal_, 1 / seen.angle);
        }
    }
    const bool first = takes_first(place.x, first_area_ / area_);
    const Vec3 point = first ? point_of(a_, b_, c_, place) : point_of(a_, c_, d_, place);
    return chosen_by_area(from, point, normal_, area_);
}

double TwoTrianglesArea::pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const {
    if (is_near(from, centre(), area_)) {
        const SeenPair seen(from, a_, b_, c_, d_);
        if (seen.is_accurate()) return 1 / seen.angle;
    }
    return per_steradian(1 / area_, from, position, normal);
}

}  // namespace etalon
