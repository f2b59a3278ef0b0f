// What the float filter of the BVH's leaves lets through, against what the kernel hits.
#include "native_accel/bvh/triangle_filter.h"

#include "core/intersect/kernels.h"
#include "core/render/aimed_rays.h"
#include "tests/backends/rays.h"
#include "tests/backends/scenes.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// A scene's triangles in leaves, and how the filter did with them.
class Trial {
  public:
    explicit Trial(const Scene& scene) : scene_(scene) {
        SceneBounds bounds = SceneBounds::of(scene);
        frame_ = bounds.frame;
        for (const BoundedPrimitive& p : bounds.bounded) {
            if (scene.primitives[p.id].kind != kind_of<Triangle>()) continue;
            const std::size_t lane = triangles_++ % TriangleLeaf::lanes;
            if (lane == 0) leaves_.emplace_back();
            leaves_.back().set(lane, scene, frame_, p.id);
        }
    }

    void shoot(const Ray& ray) {
        if (!frame_.resolves(ray)) return;
        const auto local = frame_.ray(ray);
        if (!local) return;
        const RayQuery query(ray);
        const TriangleFilter filter(*local);
        for (std::size_t i = 0; i < triangles_; ++i) {
            const TriangleLeaf& leaf = leaves_[i / TriangleLeaf::lanes];
            const std::size_t lane = i % TriangleLeaf::lanes;
            const auto passes = [&](double tmax) {
                return filter.candidates(leaf, local->tmax(tmax))[lane] != 0;
            };
            const double t = primitive_first_hit(scene_, leaf.ids[lane], query);
            if (std::isnan(t)) {
                ++missed;
                if (!passes(infinity)) ++missed_and_dropped;
            } else {
                ++hit;
                if (!passes(infinity) || !passes(t)) ++hit_and_dropped;
                if (!passes(t / 2)) ++hit_beyond_and_dropped;
            }
        }
    }

    std::size_t hit = 0, hit_and_dropped = 0, hit_beyond_and_dropped = 0;
    std::size_t missed = 0, missed_and_dropped = 0;

  private:
    const Scene& scene_;
    Frame frame_;
    std::vector<TriangleLeaf> leaves_;
    std::size_t triangles_ = 0;
};

void require_no_hit_dropped(const Scene& scene, std::size_t rays) {
    Trial trial(scene);
    test::Random random(rays);
    for (const Ray& ray : make_rays(scene, rays, random)) trial.shoot(ray);
    const Box3 around(scene.camera.eye - Vec3(2), scene.camera.eye + Vec3(2));
    for (const Ray& ray : rays_at_features(scene, around, rays)) trial.shoot(ray);
    CHECK(trial.hit_and_dropped == 0);
}

/// A triangle of any size anywhere in the frame, or of corners that nearly fall together, or whose
/// plane nearly contains `eye`.
std::array<Vec3, 3> hostile_triangle(const Vec3& eye, test::Random& random) {
    const Vec3 place = random.in_cube(), along = random.magnitude(-8, 0) * random.direction();
    const Vec3 aside = random.magnitude(-8, 0) * random.direction();
    const Vec3 dust = random.magnitude(-16, -6) * random.direction();
    switch (random.below(3)) {
        case 0:
            return {place, place + along, place + aside};
        case 1:
            return {place, place + along, place + random.between(0, 1) * along + dust};
        default: {
            const Vec3 sight = (place - eye) / max_abs(place - eye);
            return {place, place + along, place + random.between(-1, 1) * sight + dust};
        }
    }
}

Scene hostile_triangles(const Vec3& eye, std::size_t count) {
    Scene scene;
    scene.camera.eye = eye;
    test::Random random(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        for (const Vec3& corner : hostile_triangle(eye, random)) scene.vertices.push_back(corner);
        scene.add(Triangle{{3 * i, 3 * i + 1, 3 * i + 2}}, 0);
    }
    return scene;
}

}  // namespace

TEST_CASE("Given any scene, the filter drops no triangle that is hit", "[triangle_filter]") {
    for (const SceneFamily& family : scene_families()) {
        INFO(family.name);
        require_no_hit_dropped(family.make(200), 1000);
        require_no_hit_dropped(transformed(family.make(50), 1e-3, Vec3(148376, 1234, -223423)),
                               1000);
    }
}

TEST_CASE("Given slivers, edge-on, tiny and huge triangles, the filter drops none that is hit",
          "[triangle_filter]") {
    for (const double distance : {0.0, 0.5, 2.0, 10.0, 1e4, 1e7}) {
        INFO("eye " << distance << " away");
        const Vec3 eye = distance * Vec3(0.6, -0.64, 0.48);
        require_no_hit_dropped(hostile_triangles(eye, 200), 4000);
    }
}

TEST_CASE("Given random rays, the filter drops nearly all that they miss or hit beyond tmax",
          "[triangle_filter]") {
    const Scene scene = make_scene("triangles", 300);
    Trial trial(scene);
    test::Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 origin = random.in_cube(2);
        trial.shoot({origin, random.in_cube() - origin});
    }
    CAPTURE(trial.hit, trial.hit_beyond_and_dropped, trial.missed, trial.missed_and_dropped);
    CHECK(trial.hit > 1000);
    CHECK(100 * trial.missed_and_dropped > 99 * trial.missed);
    CHECK(10 * trial.hit_beyond_and_dropped > 9 * trial.hit);
}
