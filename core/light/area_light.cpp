#include "core/light/area_light.h"

#include <algorithm>
#include <numbers>

#include "core/intersect/kernels.h"
#include "core/light/strength.h"

namespace etalon {
namespace {

constexpr double pi = std::numbers::pi;

double area_of(const AreaShape& shape) {
    return std::visit([](const auto& s) { return s.area(); }, shape);
}

BoundingSphere bounds_of(const AreaShape& shape) {
    return std::visit([](const auto& s) { return s.bounds(); }, shape);
}

/// Returns the sum of the normals at a triangle's corners.
Vec3 sum_of_normals(const Geometry& geometry, const Triangle& triangle) {
    Vec3 sum(0);
    for (std::size_t k = 0; k < 3; ++k) {
        sum += geometry.normals[Geometry::normal_number(triangle, k)];
    }
    return sum;
}

/// Returns the normal of the side that emits; that of a shape by itself is `normal`. Normals at
/// corners tell which side of a triangle is the front.
Vec3 front(const Geometry& geometry, const Primitive& primitive, const SurfaceBinding& binding,
           const Vec3& normal) {
    const double sign = binding.flipped ? -1 : 1;
    const Vec3 own = normal * sign;
    if (!binding.corner_normals) return own;
    const Vec3 sum = sum_of_normals(geometry, geometry.get<Triangle>(primitive)) * sign;
    return own.dot(sum) < 0 ? -own : own;
}

}  // namespace

void AreaLight::join(const AreaShape& both) {
    exitance *= area_of(both) / area_of(shape);
    shape = both;
    bounds = bounds_of(both);
    is_joined = true;
}

bool AreaLight::shines(const Vec3& normal, const Vec3& ray) const {
    if (two_sided) return true;
    const Vec3 front = flat_front ? *flat_front : flipped ? -normal : normal;
    return front.dot(ray) < 0;
}

bool AreaLight::turns_from(const Vec3& point) const {
    return flat_front && !two_sided && flat_front->dot(point - bounds.centre) <= 0;
}

double AreaLight::facing(const Vec3& back) const {
    if (!flat_front) return 1;
    const double front = largest_cosine(*flat_front, back, bounds.radius);
    if (two_sided) return std::max(front, largest_cosine(-*flat_front, back, bounds.radius));
    return flat_front->dot(back) > 0 ? front : 0;
}

LightBounds AreaLight::light_bounds(const Geometry& geometry) const {
    Box3 box = primitive_bounds(geometry, primitive);
    if (is_joined) box.extendBy(primitive_bounds(geometry, primitive + 1));
    const double sides = two_sided ? 2 : 1;
    if (flat_front) return {box, {*flat_front, 0, pi / 2, two_sided}, exitance / sides};
    // A sphere shows a quarter of its area.
    return {box, {{0, 0, 1}, pi, pi / 2, false}, exitance / (4 * sides)};
}

AreaLight area_light(const Scene& scene, const AreaSource& source, std::uint32_t primitive) {
    const Geometry& geometry = scene.geometry;
    const SurfaceBinding& binding =
        scene.physical().bindings[geometry.primitives[primitive].material];
    const std::optional<AreaShape> own = area_shape(geometry, primitive);
    const AreaShape shape = own.value_or(SphereArea(Sphere{Vec3(0), 1}));
    const double sides = source.two_sided ? 2 : 1;
    AreaLight light{shape,
                    source.radiance,
                    bounds_of(shape),
                    std::visit([](const auto& s) { return s.flat_normal(); }, shape),
                    own ? area_of(shape) * strength(source.radiance) * sides : 0,
                    primitive,
                    false,
                    binding.flipped,
                    source.two_sided,
                    binding.alpha.texture == no_index && binding.alpha.value == 0};
    if (light.flat_front) {
        const Primitive& p = geometry.primitives[primitive];
        *light.flat_front = front(geometry, p, binding, *light.flat_front);
    }
    return light;
}

}  // namespace etalon
