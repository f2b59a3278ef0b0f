#include "core/sampling/outline.h"

namespace etalon {
namespace {

Vec3 in_triangle(const Vec3& a, const Vec3& b, const Vec3& c, Random& random) {
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    return a + u * (b - a) + v * (c - a);
}

}  // namespace

Outline::Outline(const Scene& scene, std::uint32_t primitive) : vertices_(scene.vertices.data()) {
    const Primitive& p = scene.primitives[primitive];
    if (p.kind == kind_of<Triangle>()) {
        triangle_ = scene.get<Triangle>(p).vertices.data();
    } else {
        first_ = scene.get<Polygon>(p).first;
        size_ = scene.get<Polygon>(p).count;
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
