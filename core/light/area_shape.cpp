#include "core/light/area_shape.h"

#include <array>
#include <numbers>

#include "core/intersect/shapes/triangle.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

/// Returns a point uniformly distributed on the unit sphere.
Vec3 on_unit_sphere(const Vec2& uv) {
    const double z = 1 - 2 * uv.x, r = std::sqrt(std::max(0.0, 1 - z * z)), phi = 2 * pi * uv.y;
    return {r * std::cos(phi), r * std::sin(phi), z};
}

/// Returns the columns of the matrix that maps areas of the unit sphere to those of its image.
std::array<Vec3, 3> cofactors_of(const Affine& map) {
    const double outward = std::copysign(1.0, map.determinant());
    return {outward * map.y.cross(map.z), outward * map.z.cross(map.x),
            outward * map.x.cross(map.y)};
}

}  // namespace

double SphereArea::area() const {
    return 4 * pi * sphere_.radius * sphere_.radius;
}

std::optional<double> SphereArea::cone(const Vec3& from) const {
    const Vec3 to_centre = sphere_.centre - from;
    const double sine2 = sphere_.radius * sphere_.radius / to_centre.dot(to_centre);
    // A point of the sphere itself is on either side of it by roundings. If the cone is close to a
    // hemisphere, sampling the area is as good.
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
    const Vec3 to_centre = centre - from;
    const double distance = std::sqrt(to_centre.dot(to_centre)),
                 height = uv.x * *cap;  // 1 - cosine
    const double cosine = 1 - height, sine2 = height * (2 - height);
    // The nearer of the two points where the direction meets the sphere, seen from its centre.
    const double near =
        distance * cosine - std::sqrt(std::max(0.0, radius * radius - distance * distance * sine2));
    Vec3 x, y;
    const Vec3 axis = to_centre / distance;
    orthonormal_basis(axis, x, y);
    const double sine = std::sqrt(sine2), phi = 2 * pi * uv.y;
    const Vec3 direction = sine * std::cos(phi) * x + sine * std::sin(phi) * y + cosine * axis;
    const Vec3 normal = normalized(near * direction - to_centre);
    return {centre + radius * normal, normal, 1 / (2 * pi * *cap)};
}

double SphereArea::pdf(const Vec3& from, const Vec3& position, const Vec3& normal) const {
    const std::optional<double> cap = cone(from);
    if (!cap) return per_steradian(1 / area(), from, position, normal);
    const bool is_far_side = (position - sphere_.centre).dot(position - from) > 0;
    return is_far_side ? 0 : 1 / (2 * pi * *cap);
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

EllipsoidArea::EllipsoidArea(const Affine& to_world) : to_world_(to_world) {
    // Thomsen's formula, good to 1.1 %, which suffices for powers.
    constexpr double p = 1.6075;
    double sum = 0;
    for (const Vec3& column : cofactors_of(to_world)) sum += std::pow(column.length(), p);
    area_ = 4 * pi * std::pow(sum / 3, 1 / p);
}

Vec3 EllipsoidArea::stretched_normal(const Vec3& unit) const {
    const auto [x, y, z] = cofactors_of(to_world_);
    return unit.x * x + unit.y * y + unit.z * z;
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
        } else if constexpr (std::is_same_v<Shape, Revolved>) {
            return RevolvedArea(geometry.get<Revolved>(p));
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
