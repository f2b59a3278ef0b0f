// Scaling a scene by a power of two changes only the exponent of t: no computation depends on an
// absolute length.
#include "embree_backend/embree_backends.h"
#include "native_accel/native_backends.h"
#include "tests/backends/scenes.h"
#include "tests/backends/test_rays.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Returns the ray of the scaled scene that corresponds to `ray`, if it can be represented exactly.
std::optional<Ray> scaled(const Ray& ray, double factor) {
    const Ray result{factor * ray.origin, factor * ray.direction, ray.tmin, ray.tmax};
    if (result.origin / factor != ray.origin || result.direction / factor != ray.direction) {
        return std::nullopt;
    }
    return result;
}

std::size_t count_different(const Backend& backend, const Scene& scene,
                            const std::vector<Ray>& rays, double factor) {
    const Scene scaled_scene = transformed(scene, factor);
    const auto before = backend.build(scene.geometry), after = backend.build(scaled_scene.geometry);
    std::size_t different = 0;
    for (const Ray& ray : rays) {
        const std::optional<Ray> other = scaled(ray, factor);
        if (!other) continue;
        const auto a = before->closest(ray), b = after->closest(*other);
        const bool same = a && b ? a->t == b->t && a->primitive == b->primitive : !a && !b;
        if (!same) ++different;
    }
    return different;
}

/// Returns the number of rays whose hit changes if only their direction is scaled.
std::size_t count_changed(const Intersector& intersector, const std::vector<Ray>& rays,
                          double factor) {
    std::size_t changed = 0;
    for (Ray ray : rays) {
        const auto expected = intersector.closest(ray);
        const Vec3 direction = factor * ray.direction;
        if (direction / factor != ray.direction) continue;
        ray.direction = direction;
        ray.tmin /= factor;
        ray.tmax /= factor;
        const auto hit = intersector.closest(ray);
        const bool same = hit && expected ? hit->t == expected->t / factor &&
                                                hit->primitive == expected->primitive
                                          : !hit && !expected;
        if (!same || intersector.occluded(ray) != hit.has_value()) ++changed;
    }
    return changed;
}

}  // namespace

TEST_CASE("Given directions of extreme length, every backend gives the same hits", "[backends]") {
    for (const char* family : {"mix", "duplicates", "slivers"}) {
        const Scene scene = make_scene(family, 100);
        Random random(8);
        std::vector<Ray> rays = make_rays(scene, 500, random);
        for (Ray& ray : rays) ray.direction = to_unit_magnitude(ray.direction);
        for (const Backend& backend : exact_backends()) {
            const auto intersector = backend.build(scene.geometry);
            for (const int k : {-960, -600, -500, 400, 600, 900}) {
                INFO(family << " by " << backend.name << ", k = " << k);
                CHECK(count_changed(*intersector, rays, std::ldexp(1.0, k)) == 0);
            }
        }
    }
}

TEST_CASE("Given a scene scaled by 2^k, every backend gives the same hits", "[backends]") {
    for (const char* family : {"mix", "duplicates", "slivers", "far"}) {
        const Scene scene = make_scene(family, 200);
        Random random(7);
        const std::vector<Ray> rays = make_rays(scene, 1000, random);
        for (const auto& part : {native_backends(), embree_backends()}) {
            for (const Backend& backend : part) {
                for (const int k : {-20, 20, 60}) {
                    INFO(family << " by " << backend.name << ", k = " << k);
                    CHECK(count_different(backend, scene, rays, std::ldexp(1.0, k)) == 0);
                }
            }
        }
    }
}
