#include "core/light/area_shape.h"

#include <numbers>

#include "core/intersect/shapes/triangle.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

/// Density per steradian, at `from`, of a point chosen with a density per area.
double per_steradian(double per_area, const Vec3& from, const Vec3& position, const Vec3& normal) {
    const Vec3 way = position - from;
    const double distance2 = way.dot(way), cosine = std::abs(normal.dot(way));
    return cosine > 0 ? per_area * distance2 * std::sqrt(distance2) / cosine : 0;
}

AreaPoint chosen_by_area(const Vec3& from, const Vec3& position, const Vec3& normal, double area) {
    return {position, normal, per_steradian(1 / area, from, position, normal)};
}

/// Evenly distributed on the unit sphere.
Vec3 on_unit_sphere(const Vec2& uv) {
    const double z = 1 - 2 * uv.x, r = std::sqrt(std::max(0.0, 1 - z * z)), phi = 2 * pi * uv.y;
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// The part of `v` across the unit vector `axis`, made a unit vector.
Vec3 across(const Vec3& v, const Vec3& axis) {
    return normalized(v - v.dot(axis) * axis);
}

}  // namespace

TriangleArea::TriangleArea(const Vec3& a, const Vec3& b, const Vec3& c) : a_(a), b_(b), c_(c) {
    const Vec3 n = (b - a).cross(c - a);
    const double length = std::sqrt(n.dot(n));
    normal_ = n / length;
    area_ = length / 2;
}

BoundingSphere TriangleArea::bounds() const {
    const Vec3 centre = (a_ + b_ + c_) / 3;
    const double radius2 =
        std::max({(a_ - centre).length2(), (b_ - centre).length2(), (c_ - centre).length2()});
    return {centre, std::sqrt(radius2)};
}

namespace {

/// A triangle seen from a point: its corners' directions.
struct SphericalTriangle {
    SphericalTriangle(const Vec3& from, const Vec3& p, const Vec3& q, const Vec3& r)
        : a(normalized(p - from)), b(normalized(q - from)), c(normalized(r - from)) {}

    /// Van Oosterom and Strackee 1983.
    double solid_angle() const {
        const double base = 1 + a.dot(b) + b.dot(c) + c.dot(a);
        return 2 * std::atan2(std::abs(a.dot(b.cross(c))), base);
    }

    /// The direction at uv, of a triangle of that solid angle (Arvo 1995): first a part next to a
    /// of uv.x of the solid angle, then a point of the arc from b that bounds it.
    std::optional<Vec3> direction(double solid_angle, const Vec2& uv) const {
        const Vec3 at_a_b = normalized(a.cross(b)), at_a_c = normalized(a.cross(c));
        const double cos_alpha = at_a_b.dot(at_a_c);
        const double sin_alpha = std::sqrt(std::max(0.0, 1 - cos_alpha * cos_alpha));
        // s and t: sine and cosine of pi + area - alpha, which is the sum of the part's other
        // angles.
        const double area = uv.x * solid_angle, sin_area = std::sin(area),
                     cos_area = std::cos(area);
        const double s = sin_alpha * cos_area - cos_alpha * sin_area;
        const double t = -(cos_alpha * cos_area + sin_alpha * sin_area);
        const double u = t + cos_alpha, v = s - sin_alpha * a.dot(b);
        const double q = (v + (v * t - u * s) * cos_alpha) / ((v * s + u * t) * sin_alpha);
        if (!(std::abs(q) <= 1 + 1e-6)) return std::nullopt;
        const double cos_part = std::clamp(q, -1.0, 1.0);
        const Vec3 corner = cos_part * a + std::sqrt(1 - cos_part * cos_part) * across(c, a);
        const double z = 1 - uv.y * (1 - corner.dot(b));
        const Vec3 direction = z * b + std::sqrt(std::max(0.0, 1 - z * z)) * across(corner, b);
        return is_finite(direction) ? std::optional(direction) : std::nullopt;
    }

    Vec3 a, b, c;
};

/// Whether a shape is so near for its size that sampling its solid angle instead of its area pays.
bool is_near(const Vec3& from, const BoundingSphere& bounds, double area) {
    return area > 0.1 * (bounds.centre - from).length2();
}

/// Whether the angles of spherical triangles of that solid angle are good to a few digits, as in
/// pbrt-v4.
bool is_accurate(double solid_angle) {
    return solid_angle > 3e-4 && solid_angle < 6.22;
}

/// Density of a point sampled by its solid angle, or by its area where that is 0.
double density(const Vec3& from, const AreaPoint& p, double solid_angle, double area) {
    return solid_angle > 0 ? 1 / solid_angle : per_steradian(1 / area, from, p.position, p.normal);
}

}  // namespace

double TriangleArea::solid_angle(const Vec3& from) const {
    return SphericalTriangle(from, a_, b_, c_).solid_angle();
}

AreaPoint TriangleArea::by_solid_angle(const Vec3& from, double solid_angle, const Vec2& uv) const {
    const SphericalTriangle seen(from, a_, b_, c_);
    const std::optional<Vec3> direction = seen.direction(solid_angle, uv);
    const double approach = direction ? normal_.dot(*direction) : 0;
    if (approach == 0) return {a_, normal_, 0};
    const double distance = normal_.dot(a_ - from) / approach;
    return {from + distance * *direction, normal_, 1 / solid_angle};
}

AreaPoint TriangleArea::by_area(const Vec3& from, const Vec2& uv) const {
    const double root = std::sqrt(uv.x);
    const Vec3 position = (1 - root) * a_ + root * (1 - uv.y) * b_ + root * uv.y * c_;
    return chosen_by_area(from, position, normal_, area_);
}

double TriangleArea::sampled_angle(const Vec3& from) const {
    if (!is_near(from, bounds(), area_)) return 0;
    const double angle = solid_angle(from);
    return is_accurate(angle) ? angle : 0;
}

AreaPoint TriangleArea::sample(const Vec3& from, const Vec2& uv) const {
    const double angle = sampled_angle(from);
    return angle > 0 ? by_solid_angle(from, angle, uv) : by_area(from, uv);
}

double TriangleArea::pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const {
    return density(from, {position, normal, 1}, sampled_angle(from), area_);
}

TwoTrianglesArea::TwoTrianglesArea(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
    : first_(a, b, c), second_(a, c, d) {
    const BoundingSphere p = first_.bounds(), q = second_.bounds();
    const double distance = (p.centre - q.centre).length();
    bounds_ = {(p.centre + q.centre) / 2, distance / 2 + std::max(p.radius, q.radius)};
}

TwoTrianglesArea::Angles TwoTrianglesArea::sampled_angles(const Vec3& from) const {
    if (!is_near(from, bounds_, area())) return {};
    const Angles angles{first_.solid_angle(from), second_.solid_angle(from)};
    return is_accurate(angles.first) && is_accurate(angles.second) ? angles : Angles{};
}

AreaPoint TwoTrianglesArea::sample(const Vec3& from, const Vec2& uv) const {
    const Angles angles = sampled_angles(from);
    const bool by_angle = angles.sum() > 0;
    const double share = by_angle ? angles.first / angles.sum() : first_.area() / area();
    const bool in_first = uv.x < share;
    const TriangleArea& half = in_first ? first_ : second_;
    const Vec2 place(in_first ? uv.x / share : (uv.x - share) / (1 - share), uv.y);
    AreaPoint point =
        by_angle ? half.by_solid_angle(from, in_first ? angles.first : angles.second, place)
                 : half.by_area(from, place);
    point.normal = *first_.flat_normal();
    if (point.pdf > 0) point.pdf = density(from, point, angles.sum(), area());
    return point;
}

double TwoTrianglesArea::pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const {
    return density(from, {position, normal, 1}, sampled_angles(from).sum(), area());
}

double SphereArea::area() const {
    return 4 * pi * sphere_.radius * sphere_.radius;
}

std::optional<double> SphereArea::cone(const Vec3& from) const {
    const Vec3 way = sphere_.centre - from;
    const double sine2 = sphere_.radius * sphere_.radius / way.dot(way);
    // A point of the sphere itself is on either side of it by its roundings. Where the cone is as
    // good as a hemisphere the area serves as well.
    if (!(sine2 < 1 - 1e-9)) return std::nullopt;
    return sine2 / (1 + std::sqrt(1 - sine2));
}

AreaPoint SphereArea::sample(const Vec3& from, const Vec2& uv) const {
    const auto& [centre, radius] = sphere_;
    const std::optional<double> cap = cone(from);
    if (!cap) {
        const Vec3 normal = on_unit_sphere(uv);
        return chosen_by_area(from, centre + radius * normal, normal, area());
    }
    const Vec3 way = centre - from;
    const double distance = std::sqrt(way.dot(way)), height = uv.x * *cap;  // 1 - cosine
    const double cosine = 1 - height, sine2 = height * (2 - height);
    // The nearer of the two points where the direction meets the sphere, seen from its centre.
    const double near =
        distance * cosine - std::sqrt(std::max(0.0, radius * radius - distance * distance * sine2));
    Vec3 x, y;
    const Vec3 axis = way / distance;
    orthonormal_basis(axis, x, y);
    const double sine = std::sqrt(sine2), phi = 2 * pi * uv.y;
    const Vec3 direction = sine * std::cos(phi) * x + sine * std::sin(phi) * y + cosine * axis;
    const Vec3 normal = normalized(near * direction - way);
    return {centre + radius * normal, normal, 1 / (2 * pi * *cap)};
}

double SphereArea::pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const {
    const std::optional<double> cap = cone(from);
    return cap ? 1 / (2 * pi * *cap) : per_steradian(1 / area(), from, position, normal);
}

RingArea::RingArea(const Ring& ring)
    : ring_(ring), area_(pi * (ring.outer * ring.outer - ring.inner * ring.inner)) {
    ring_.normal = normalized(ring.normal);
}

AreaPoint RingArea::sample(const Vec3& from, const Vec2& uv) const {
    const auto& [centre, normal, inner, outer] = ring_;
    const double radius = std::sqrt(inner * inner + uv.x * (outer * outer - inner * inner));
    const double phi = 2 * pi * uv.y;
    Vec3 x, y;
    orthonormal_basis(normal, x, y);
    const Vec3 position = centre + radius * (std::cos(phi) * x + std::sin(phi) * y);
    return chosen_by_area(from, position, normal, area_);
}

double RingArea::pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const {
    return per_steradian(1 / area_, from, position, normal);
}

EllipsoidArea::EllipsoidArea(const Affine& to_world)
    : to_world_(to_world),
      cofactors_{to_world.y.cross(to_world.z), to_world.z.cross(to_world.x),
                 to_world.x.cross(to_world.y)} {
    const double outward = std::copysign(1.0, to_world.determinant());
    for (Vec3& column : cofactors_) column *= outward;
    // Thomsen's formula, good to 1.1 % (only powers are made of it).
    constexpr double p = 1.6075;
    const double ab = std::pow(cofactors_[0].length(), p), bc = std::pow(cofactors_[1].length(), p),
                 ca = std::pow(cofactors_[2].length(), p);
    area_ = 4 * pi * std::pow((ab + bc + ca) / 3, 1 / p);
}

Vec3 EllipsoidArea::stretched_normal(const Vec3& unit) const {
    return unit.x * cofactors_[0] + unit.y * cofactors_[1] + unit.z * cofactors_[2];
}

AreaPoint EllipsoidArea::sample(const Vec3& from, const Vec2& uv) const {
    const Vec3 unit = on_unit_sphere(uv), stretched = stretched_normal(unit);
    const double stretch = stretched.length();  // of the area there
    return chosen_by_area(from, to_world_.point(unit), stretched / stretch, 4 * pi * stretch);
}

double EllipsoidArea::pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const {
    // A normal N of the image belongs to the point u of the sphere with N = C u / |C u|: u is
    // along C^-1 N, which is A^T N up to a factor, and |C u| = 1 / |C^-1 N| = |det A| / |A^T N|.
    const Vec3 pulled(to_world_.x.dot(normal), to_world_.y.dot(normal), to_world_.z.dot(normal));
    const double stretch = std::abs(to_world_.determinant()) / pulled.length();
    return per_steradian(1 / (4 * pi * stretch), from, position, normal);
}

BoundingSphere EllipsoidArea::bounds() const {
    const double radius2 = to_world_.x.length2() + to_world_.y.length2() + to_world_.z.length2();
    return {to_world_.origin, std::sqrt(radius2)};
}

std::optional<AreaShape> area_shape(const Geometry& geometry, std::uint32_t primitive) {
    const Primitive p = geometry.primitives[primitive];
    return with_shape(p.kind, [&]<class Shape>() -> std::optional<AreaShape> {
        if constexpr (std::is_same_v<Shape, Triangle>) {
            const auto [a, b, c] = corners(geometry, geometry.get<Triangle>(p));
            return TriangleArea(a, b, c);
        } else if constexpr (std::is_same_v<Shape, Sphere>) {
            return SphereArea(geometry.get<Sphere>(p));
        } else if constexpr (std::is_same_v<Shape, Ring>) {
            return RingArea(geometry.get<Ring>(p));
        } else if constexpr (std::is_same_v<Shape, Ellipsoid>) {
            const Affine& map = geometry.get<Ellipsoid>(p).to_world;
            const std::optional<double> radius = scale_of(map);
            if (radius) return SphereArea(Sphere{map.origin, *radius});
            return EllipsoidArea(map);
        } else {
            return std::nullopt;
        }
    });
}

std::optional<TwoTrianglesArea> quadrilateral(const Geometry& geometry, std::uint32_t primitive) {
    if (primitive + 1 >= geometry.primitives.size()) return std::nullopt;
    const Primitive p = geometry.primitives[primitive], q = geometry.primitives[primitive + 1];
    if (p.kind != kind_of<Triangle>() || q.kind != p.kind || q.material != p.material) {
        return std::nullopt;
    }
    const auto first = corners(geometry, geometry.get<Triangle>(p)),
               second = corners(geometry, geometry.get<Triangle>(q));
    const auto at = [](const auto& c, std::size_t k) { return c[k % 3]; };
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            // The edge from a to c of the first is that from c to a of the second.
            const Vec3 a = at(first, i), b = at(first, i + 1), c = at(first, i + 2),
                       d = at(second, j + 2);
            if (at(second, j) != a || at(second, j + 1) != c) continue;
            const Vec3 n = (b - a).cross(c - a), m = (c - a).cross(d - a);
            const bool is_flat =
                n.dot(m) > 0 && n.cross(m).length2() <= 1e-18 * n.dot(m) * n.dot(m);
            if (is_flat) return TwoTrianglesArea(a, b, c, d);
        }
    }
    return std::nullopt;
}

}  // namespace etalon
