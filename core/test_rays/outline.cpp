#include "core/test_rays/outline.h"

namespace etalon {
namespace {

Vec3 in_triangle(const Vec3& a, const Vec3& b, const Vec3& c, Random& random) {
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    return a + u * (b - a) + v * (c - a);
}

}  // namespace

Outline::Outline(const Geometry& geometry, std::uint32_t primitive) {
    const Primitive p = geometry.primitives[primitive];
    if (p.kind == kind_of<Triangle>()) {
        for (const std::uint32_t v : geometry.get<Triangle>(p).vertices) {
            corners_.push_back(geometry.vertex(v));
        }
    } else {
        const std::span<const Vec3> corners = geometry.get<Polygon>(p).corners;
        corners_.assign(corners.begin(), corners.end());
    }
}

Vec3 point_of(const Outline& face, Feature feature, Random& random) {
    if (feature == Feature::points) {
        const auto i = static_cast<std::uint32_t>(1 + random.index(face.size() - 2));
        return in_triangle(face[0], face[i], face[i + 1], random);
    }
    const auto i = static_cast<std::uint32_t>(random.index(face.size()));
    const Vec3 &a = face[i], &b = face[(i + 1) % face.size()];
    if (feature == Feature::vertices) return a;
    return a + (feature == Feature::edges ? random.uniform() : 0.5) * (b - a);
}

}  // namespace etalon
