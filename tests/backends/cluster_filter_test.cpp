// Compares the float filters of clusters with the kernels, and whole traversals of the tree, for
// every instruction set that they are compiled for and this machine has.
#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/backends/cluster_filter_test.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/accel/clusters/clusters.h"
#include "core/accel/clusters/filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

/// The lanes of a cluster of triangles or spheres that pass.
std::uint32_t candidates(const Clusters& clusters, ClusterRef ref, const RayQuery& query,
                         const NormalizedRay& local, float tmin, float tmax) {
    return ClusterFilter(clusters, query, local, tmin).candidates(clusters, ref, tmax);
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "core/test_rays/aimed_rays.h"
#include "native_accel/bvh/bvh.h"
#include "tests/backends/scenes.h"
#include "tests/backends/test_rays.h"
#include "tests/backends/tracers.h"
#include "tests/each_instruction_set.h"

namespace etalon {
HWY_EXPORT(candidates);
}

using namespace etalon;
using namespace etalon::test;

namespace {

/// A scene's triangles and spheres in clusters, and counts of the filters' results.
class Trial {
  public:
    explicit Trial(const Scene& scene) : scene_(scene) {
        SceneBounds bounds = SceneBounds::of(scene.geometry);
        space_ = bounds.space;
        std::vector<std::uint32_t> ids;
        for (const ShapeKind kind : {kind_of<Triangle>(), kind_of<Sphere>()}) {
            const std::size_t first = ids.size();
            for (const BoundedPrimitive& p : bounds.bounded) {
                if (scene.geometry.primitives[p.id].kind == kind) ids.push_back(p.id);
            }
            for (std::size_t i = first; i < ids.size(); i += cluster_lanes) {
                const std::size_t count = std::min(cluster_lanes, ids.size() - i);
                ranges_.push_back(
                    {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(count)});
            }
        }
        refs_ = cluster_refs(scene.geometry, ids, ranges_);
        clusters_ = Clusters(scene.geometry, space_, ids, ranges_, refs_);
    }

    void shoot(const Ray& ray) {
        if (!space_.resolves(ray)) return;
        const auto local = space_.ray(ray);
        if (!local) return;
        for (std::size_t i = 0; i < refs_.size(); ++i) {
            for (std::uint32_t lane = 0; lane < ranges_[i].count; ++lane) {
                shoot(ray, *local, refs_[i], lane);
            }
        }
    }

    std::size_t hit = 0, hit_and_dropped = 0, hit_beyond_and_dropped = 0;
    std::size_t missed = 0, missed_and_dropped = 0, left_and_passed = 0;

  private:
    void shoot(const Ray& ray, const NormalizedRay& local, ClusterRef ref, std::uint32_t lane) {
        const float tmin = local.tmin(ray.tmin);
        const auto passes = [&](double tmax, std::uint32_t exclude = no_index) {
            RayQuery query(ray);
            query.ray.exclude = exclude;
            const std::uint32_t lanes = HWY_DYNAMIC_DISPATCH(candidates)(
                clusters_, ref, query, local, tmin, local.tmax(tmax));
            return (lanes >> lane & 1) != 0;
        };
        const auto [id, t] = clusters_.intersect_lane(scene_.geometry, ref, lane, RayQuery(ray));
        if (passes(infinity, id)) ++left_and_passed;
        if (std::isnan(t)) {
            ++missed;
            if (!passes(infinity)) ++missed_and_dropped;
        } else {
            ++hit;
            if (!passes(infinity) || !passes(t)) ++hit_and_dropped;
            if (!passes(t / 2)) ++hit_beyond_and_dropped;
        }
    }

    const Scene& scene_;
    NormalizedSpace space_;
    Clusters clusters_;
    std::vector<Range> ranges_;
    std::vector<ClusterRef> refs_;
};

void require_no_hit_dropped(const Scene& scene, std::size_t rays) {
    Trial trial(scene);
    Random random(rays);
    for (const Ray& ray : make_rays(scene, rays, random)) trial.shoot(ray);
    const Box3 around(scene.camera.eye - Vec3(2), scene.camera.eye + Vec3(2));
    for (const Ray& ray : rays_at_features(scene, around, rays)) trial.shoot(ray);
    CHECK(trial.hit_and_dropped == 0);
    CHECK(trial.left_and_passed == 0);
}

/// Returns a triangle of any size anywhere in normalized space, or with nearly coincident vertices,
/// or whose plane nearly contains `eye`.
std::array<Vec3, 3> adversarial_triangle(const Vec3& eye, Random& random) {
    const Vec3 place = random.in_cube(), along = random.magnitude(-8, 0) * random.direction();
    const Vec3 aside = random.magnitude(-8, 0) * random.direction();
    const Vec3 dust = random.magnitude(-16, -6) * random.direction();
    switch (random.index(3)) {
        case 0:
            return {place, place + along, place + aside};
        case 1:
            return {place, place + along, place + random.uniform(0, 1) * along + dust};
        default: {
            const Vec3 sight = (place - eye) / max_abs(place - eye);
            return {place, place + along, place + random.uniform(-1, 1) * sight + dust};
        }
    }
}

Scene adversarial_triangles(const Vec3& eye, std::size_t count) {
    Scene scene;
    scene.camera.eye = eye;
    Random random(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        for (const Vec3& corner : adversarial_triangle(eye, random))
            scene.geometry.vertices.push_back(corner);
        scene.geometry.add(Triangle{{3 * i, 3 * i + 1, 3 * i + 2}}, 0);
    }
    return scene;
}

/// Returns a sphere of any size anywhere in normalized space, often nearly tangent to rays from
/// `eye`.
Scene adversarial_spheres(const Vec3& eye, std::size_t count) {
    Scene scene;
    scene.camera.eye = eye;
    Random random(count);
    for (std::size_t i = 0; i < count; ++i) {
        scene.geometry.add(Sphere{random.in_cube(), random.magnitude(-9, 0)}, 0);
    }
    return scene;
}

std::size_t different_hits(const Scene& scene) {
    const Bvh bvh(scene.geometry);
    Random random(7);
    const std::vector<Ray> rays = make_rays(scene, 1000, random);
    return static_cast<std::size_t>(std::count_if(rays.begin(), rays.end(), [&](const Ray& ray) {
        return !difference(bvh, ray, brute_force(scene, ray)).empty();
    }));
}

}  // namespace

TEST_CASE("Given any scene, the filters drop nothing that is hit but what the ray has left",
          "[clusters]") {
    for_each_target([] {
        for (const SceneFamily& family : scene_families()) {
            INFO(family.name);
            require_no_hit_dropped(family.make(100), 500);
            require_no_hit_dropped(transformed(family.make(50), 1e-3, Vec3(148376, 1234, -223423)),
                                   500);
        }
    });
}

TEST_CASE("Given slivers, edge-on, tiny and huge triangles, the filter drops none that is hit",
          "[clusters]") {
    for_each_target([] {
        for (const double distance : {0.0, 0.5, 2.0, 10.0, 1e4, 1e7}) {
            INFO("eye " << distance << " away");
            const Vec3 eye = distance * Vec3(0.6, -0.64, 0.48);
            require_no_hit_dropped(adversarial_triangles(eye, 100), 2000);
        }
    });
}

TEST_CASE("Given tiny and huge spheres, the filter drops none that is hit", "[clusters]") {
    for_each_target([] {
        for (const double distance : {0.0, 0.5, 2.0, 10.0, 1e4, 1e7}) {
            INFO("eye " << distance << " away");
            const Vec3 eye = distance * Vec3(0.6, -0.64, 0.48);
            require_no_hit_dropped(adversarial_spheres(eye, 100), 2000);
        }
    });
}

TEST_CASE("Given random rays, the filters drop nearly all that they miss or hit beyond tmax",
          "[clusters]") {
    for (const char* family : {"triangles", "spheres"}) {
        CAPTURE(family);
        const Scene scene = make_scene(family, 300);
        Trial trial(scene);
        Random random(1);
        for (int i = 0; i < 20000; ++i) {
            const Vec3 origin = random.in_cube(2);
            trial.shoot({origin, random.in_cube() - origin});
        }
        CAPTURE(trial.hit, trial.hit_beyond_and_dropped, trial.missed, trial.missed_and_dropped);
        CHECK(trial.hit > 1000);
        CHECK(100 * trial.missed_and_dropped > 99 * trial.missed);
        CHECK(10 * trial.hit_beyond_and_dropped > 9 * trial.hit);
    }
}

TEST_CASE("The hits are the same with every instruction set", "[clusters]") {
    for_each_target([] {
        for (const SceneFamily& family : scene_families()) {
            INFO(family.name);
            CHECK(different_hits(family.make(300)) == 0);
        }
    });
}

#endif
