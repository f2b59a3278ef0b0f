// Translating a scene and its rays by exact sums changes no hit: kernels use differences only, and
// the accelerators' normalized space is translated, too.
#include "embree_backend/embree_backends.h"
#include "tests/backends/scenes.h"
#include "tests/backends/test_rays.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

const Vec3 far_away(0x1p20, -0x1p20, 0x1p20);

/// Rounds coordinates so that their translation is exact in double.
Scene snapped(const Scene& scene) {
    return transformed(transformed(scene, 1, far_away), 1, -far_away);
}

std::size_t count_different(const Backend& backend, const Scene& scene,
                            const std::vector<Ray>& rays) {
    const Scene moved_scene = transformed(scene, 1, far_away);
    const auto here = backend.build(scene.geometry), there = backend.build(moved_scene.geometry);
    std::size_t different = 0;
    for (Ray ray : rays) {
        Ray moved = ray;
        moved.origin += far_away;
        ray.origin = moved.origin - far_away;
        const auto a = here->closest(ray), b = there->closest(moved);
        const bool same = a && b ? a->t == b->t && a->primitive == b->primitive : !a && !b;
        if (!same) ++different;
    }
    return different;
}

}  // namespace

TEST_CASE("Given a scene moved by 2^20 of its extents, every exact backend gives the same hits",
          "[backends]") {
    for (const SceneFamily& family : scene_families()) {
        if (family.name == "far") continue;  // it is already far away
        // No sum with so much larger numbers is exact.
        if (family.name == "outliers" || family.name == "far_shell") continue;
        const Scene scene = snapped(family.make(200));
        Random random(8);
        const std::vector<Ray> rays = make_rays(scene, 1000, random);
        for (const Backend& backend : exact_backends()) {
            INFO(family.name << " by " << backend.name);
            CHECK(count_different(backend, scene, rays) == 0);
        }
    }
}
