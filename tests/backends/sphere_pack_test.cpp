// Compares the filter of the grid's packs of spheres with the kernel, for every instruction set
// that it is compiled for and this machine has.
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/backends/sphere_pack_test.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "native_accel/grid/sphere_pack_filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// The lanes of a pack that pass.
std::uint32_t passing_spheres(const SpherePack& pack, const NormalizedRay& ray) {
    return SpherePackFilter(ray).candidates(pack);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "core/intersect/bounded.h"
#include "core/intersect/kernels.h"
#include "tests/backends/scenes.h"
#include "tests/backends/test_rays.h"
#include "tests/each_instruction_set.h"

namespace etalon {
HWY_EXPORT(passing_spheres);
}

using namespace etalon;
using namespace etalon::test;

namespace {

/// Counts the filter's results for the spheres of a scene that the kernel hits or misses.
class Trial {
  public:
    explicit Trial(const Scene& scene) : scene_(scene) {
        const SceneBounds bounds = SceneBounds::of(scene.geometry);
        space_ = bounds.space;
        for (const BoundedPrimitive& p : bounds.bounded) {
            if (static_cast<ShapeKind>(p.kind) != kind_of<Sphere>()) continue;
            const Sphere& s = scene.geometry.get<Sphere>(scene.geometry.primitives[p.id]);
            const std::size_t lane = spheres_++ % cluster_lanes;
            if (lane == 0) packs_.emplace_back();
            packs_.back().set(lane,
                              {p.box(), p.id, space_.point(s.centre), s.radius * space_.scale()});
        }
    }

    void shoot(const Ray& ray) {
        if (!space_.resolves(ray)) return;
        const auto local = space_.ray(ray);
        if (!local) return;
        for (std::size_t i = 0; i < packs_.size() * cluster_lanes; ++i) {
            const SpherePack& pack = packs_[i / cluster_lanes];
            const std::size_t lane = i % cluster_lanes;
            const std::uint32_t lanes = HWY_DYNAMIC_DISPATCH(passing_spheres)(pack, *local);
            const bool passes = (lanes >> lane & 1) != 0;
            if (i >= spheres_) {
                empty_and_passed += passes ? 1 : 0;
            } else if (std::isnan(
                           primitive_first_hit(scene_.geometry, pack.ids[lane], RayQuery(ray)))) {
                ++missed;
                missed_and_passed += passes ? 1 : 0;
            } else {
                ++hit;
                hit_and_dropped += passes ? 0 : 1;
            }
        }
    }

    std::size_t hit = 0, hit_and_dropped = 0, missed = 0, missed_and_passed = 0;
    std::size_t empty_and_passed = 0;

  private:
    const Scene& scene_;
    NormalizedSpace space_;
    std::vector<SpherePack> packs_;
    std::size_t spheres_ = 0;
};

}  // namespace

TEST_CASE("Given any scene, the filter of the grid's packs drops no sphere that is hit", "[grid]") {
    for_each_target([] {
        for (const SceneFamily& family : scene_families()) {
            INFO(family.name);
            for (const Scene& scene :
                 {family.make(101),
                  transformed(family.make(50), 1e-3, Vec3(148376, 1234, -223423))}) {
                Trial trial(scene);
                Random random(3);
                for (const Ray& ray : make_rays(scene, 500, random)) trial.shoot(ray);
                CHECK(trial.hit_and_dropped == 0);
                CHECK(trial.empty_and_passed == 0);
            }
        }
    });
}

TEST_CASE("Given random rays, the filter of the grid's packs drops nearly all that is missed",
          "[grid]") {
    const Scene scene = make_scene("spheres", 300);
    Trial trial(scene);
    Random random(1);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 origin = random.in_cube(2);
        trial.shoot({origin, random.in_cube() - origin});
    }
    CHECK(trial.hit > 1000);
    CHECK(1000 * trial.missed_and_passed < trial.missed);
}

#endif
