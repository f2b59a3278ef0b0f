#include <bit>

#include "core/intersect/kernels.h"
#include "tests/catch.h"
#include "tests/intersect/rays_at_shapes.h"
#include "tests/intersect/scene_numbers.h"

using namespace etalon;

namespace {

Vec3 scaled(const Vec3& v, int k) {
    return {std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)};
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}

bool same_bits(const Vec3& a, const Vec3& b) {
    return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

/// Skips rays with a component that scaling would move below the range of double.
bool is_normal(const Ray& ray) {
    for (int k = 0; k < 3; ++k) {
        for (const double x : {ray.origin[k], ray.direction[k]}) {
            if (x != 0 && std::abs(x) < 1e-200) return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE("Kernels: given everything scaled by a power of two, then every bit is the same") {
    const int k = GENERATE(-100, -20, 20, 100);
    for (const ShapeCase& shape : shape_cases()) {
        const Scene other = scaled(shape.scene, k);
        Random random(4);
        int hits = 0;
        for (int i = 0; i < 1000; ++i) {
            const Ray ray = aimed_ray(shape, i, random).ray;
            if (!is_normal(ray)) continue;
            const Ray moved{scaled(ray.origin, k), ray.direction};
            const double t = primitive_first_hit(shape.scene.geometry, 0, RayQuery(ray));
            const double moved_t = primitive_first_hit(other.geometry, 0, RayQuery(moved));
            CAPTURE(shape.name, k, i, t, moved_t);
            REQUIRE(same_bits(std::ldexp(t, k), moved_t));
            if (!(t <= infinity)) continue;
            ++hits;
            const SurfacePoint p = surface_at(shape.scene.geometry, ray, {t, 0});
            const SurfacePoint q = surface_at(other.geometry, moved, {moved_t, 0});
            REQUIRE(same_bits(scaled(p.position, k), q.position));
            REQUIRE(same_bits(scaled(p.error, k), q.error));
            REQUIRE(same_bits(p.normal, q.normal));
        }
        REQUIRE(hits > 100);
    }
}

TEST_CASE("Kernels: given a direction scaled by a power of two, then t is scaled and no more") {
    const int k = GENERATE(-60, 60);
    for (const ShapeCase& shape : shape_cases()) {
        Random random(5);
        for (int i = 0; i < 1000; ++i) {
            const Ray ray = aimed_ray(shape, i, random).ray;
            if (!is_normal(ray)) continue;
            const double t = primitive_first_hit(shape.scene.geometry, 0, RayQuery(ray));
            const Ray other{ray.origin, scaled(ray.direction, k)};
            CAPTURE(shape.name, k, i, t);
            REQUIRE(same_bits(std::ldexp(t, -k),
                              primitive_first_hit(shape.scene.geometry, 0, RayQuery(other))));
        }
    }
}
