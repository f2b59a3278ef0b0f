// Compares the derivative of the shading normal with differences between nearby hits.
#include <optional>

#include "core/intersect/kernels.h"
#include "core/intersect/normal_change.h"
#include "core/intersect/parametrization.h"
#include "core/intersect/placement.h"
#include "core/intersect/surface.h"
#include "core/numerics/random.h"
#include "core/scene/profiles.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

/// A map that bends no plane, but keeps neither angles nor lengths.
const Affine sheared{{2, 0.5, 0}, {-0.25, 1.5, 0.5}, {0, 0.75, -1}, {1, -1, 0.5}};

template <class Shape>
Geometry one(const Shape& shape) {
    Geometry geometry;
    geometry.add(shape, 0);
    return geometry;
}

Geometry smooth_triangle() {
    Geometry geometry;
    const std::uint32_t first = geometry.add_vertex({-2, -1, 0}, normalized(Vec3(-0.5, 0, 1)));
    geometry.add_vertex({3, 0, 0.5}, normalized(Vec3(1, 0.2, 1)));
    geometry.add_vertex({0, 2, -0.25}, normalized(Vec3(0, 0.7, 1)));
    geometry.add(Triangle{{first, first + 1, first + 2}, geometry.normal_offset()}, 0);
    return geometry;
}

Geometry instance_of(const Geometry& object) {
    Geometry geometry;
    geometry.objects.push_back(object);
    geometry.instances.emplace_back(sheared, 0);
    return geometry;
}

std::optional<SurfacePoint> hit(const Geometry& geometry, const Ray& ray) {
    const std::uint32_t instance = geometry.instances.empty() ? no_index : 0;
    const double t = first_hit(geometry, key_of(0, instance), ray);
    if (!(t <= infinity)) return std::nullopt;
    return surface_at(geometry, ray, {t, 0, instance});
}

/// Returns how the shading normal changes from one side of a point to the other, per step of
/// `along`. Nothing if rays there miss, or meet another part of the surface.
std::optional<Vec3> observed_change(const Geometry& geometry, const SurfacePoint& p,
                                    const Vec3& along) {
    constexpr double step = 1e-5;
    const auto near = [&](double way) {
        const Vec3 above = p.position + way * along + step * along.length() * p.normal;
        return hit(geometry, {above, -p.normal});
    };
    const auto before = near(-step), after = near(step);
    if (!before || !after) return std::nullopt;
    const Vec3 moved = (after->position - before->position) / (2 * step);
    if ((moved - along).length() > 1e-3 * along.length()) return std::nullopt;
    return (after->shading_normal - before->shading_normal) / (2 * step);
}

}  // namespace

TEST_CASE("normal_change: given any hit, then it is the derivative of the shading normal") {
    const std::vector<Geometry> shapes = {
        one(Sphere{{0.5, 0.25, -0.5}, 1.5}),
        one(Ellipsoid(sheared)),
        one(Revolved(sheared, profiles::sphere(-0.75, 0.9), Sector(300))),
        one(Revolved(sheared, profiles::paraboloid(0.25), Sector(360))),
        one(Revolved(sheared, profiles::disk(0.25), Sector(360))),
        smooth_triangle()};
    for (std::size_t i = 0; i < 2 * shapes.size(); ++i) {
        const Geometry& shape = shapes[i / 2];
        const Geometry geometry = i % 2 == 0 ? shape : instance_of(shape);
        Random random(7);
        int compared = 0;
        for (int k = 0; k < 300; ++k) {
            const Vec3 origin = 8.0 * random.direction();
            const Ray aimed{origin, 2.0 * random.direction() - origin};
            const auto p = hit(geometry, aimed);
            if (!p) continue;
            const Parametrization at = parametrization_at(geometry, *p);
            for (const Vec3& along : {at.dpdu, at.dpdv}) {
                const auto observed = observed_change(geometry, *p, along);
                if (!observed) continue;
                CAPTURE(i, k, *observed);
                const Vec3 change = normal_change(geometry, *p, along);
                CHECK((change - *observed).length() < 1e-4 * (1 + observed->length()));
                ++compared;
            }
        }
        CHECK(compared > 20);
    }
}
