// Moving instances.
#include "core/intersect/instance_bounds.h"
#include "core/intersect/kernels.h"
#include "core/intersect/placement.h"
#include "core/numerics/random.h"
#include "core/numerics/transforms.h"
#include "core/scene/transformed.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

Affine any_map(Random& random, double most_degrees = 180) {
    Affine map = rotation(random.uniform(-most_degrees, most_degrees), random.direction()) *
                 scaling({random.uniform(0.3, 3), random.uniform(0.3, 3), random.uniform(0.3, 3)});
    map.origin = 5.0 * random.in_cube();
    return map;
}

/// A sphere, farther from the object's origin than in any reasonable scene.
Geometry moving_sphere(const AnimatedTransform& motion, const Vec3& centre = Vec3(2, 0, 1),
                       double radius = 1) {
    Geometry geometry;
    geometry.objects.resize(1);
    geometry.objects[0].add(Sphere{centre, radius}, 7);
    geometry.add_moving_instance(motion, 0);
    return geometry;
}

AnimatedTransform any_motion(Random& random, double most_degrees = 180) {
    const Affine start = any_map(random, most_degrees);
    return {start, any_map(random, most_degrees), MotionTimes{}};
}

Ray seen_at(Ray ray, ShutterTime time) {
    ray.set_time(time);
    return ray;
}

}  // namespace

TEST_CASE("A moving instance at a fixed time is the static one with the same matrix") {
    Random random(1);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const AnimatedTransform motion = any_motion(random);
        const ShutterTime time = shutter_time(random.uniform());
        const Geometry moving = moving_sphere(motion);
        Geometry still = moving;
        still.instances[0] = Instance(motion.at(time), 0);
        const Vec3 from = 10.0 * random.in_cube();
        const Vec3 target = motion.at(time).point(Vec3(2, 0, 1) + random.in_cube());
        const Ray ray = seen_at({from, target - from}, time);
        const double t = first_hit(moving, key_of(0, 0), ray);
        const double expected = first_hit(still, key_of(0, 0), ray);
        CAPTURE(i);
        REQUIRE((t == expected || (std::isnan(t) && std::isnan(expected))));
        if (!(t <= infinity)) continue;
        ++hits;
        const SurfacePoint a = surface_at(moving, ray, {t, 0, 0});
        const SurfacePoint b = surface_at(still, ray, {t, 0, 0});
        REQUIRE((a.position == b.position && a.normal == b.normal && a.error == b.error));
        REQUIRE((a.time == time && spawn_ray(a, a.normal).time() == time));
        REQUIRE(parametrization_at(moving, a).dpdu == parametrization_at(still, b).dpdu);
    }
    CHECK(hits > 1000);
}

TEST_CASE("A moving instance before and after its motion is where that begins and ends") {
    const Affine start = translation({3, 0, 0}), end = rotation(90, {0, 0, 1}) * start;
    const Geometry geometry =
        moving_sphere({start, end, MotionTimes{1, 2, 0, 4}}, Vec3(0));  // a quarter of the time
    const auto t_at = [&](const Vec3& over, double part) {
        const Ray ray = seen_at({over + Vec3(0, 0, 5), {0, 0, -1}}, shutter_time(part));
        return first_hit(geometry, key_of(0, 0), ray);
    };
    CHECK(t_at({3, 0, 0}, 0) == 4);
    CHECK(t_at({3, 0, 0}, 0.24) == 4);
    CHECK(t_at({0, 3, 0}, 0.5) == 4);
    CHECK(t_at({0, 3, 0}, 0.9) == 4);
    CHECK(std::isnan(t_at({3, 0, 0}, 0.9)));
}

TEST_CASE("The box of a moving instance holds it at all times, and is tight") {
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        const AnimatedTransform motion = any_motion(random, i % 2 == 0 ? 180 : 3);
        const double radius = i % 4 < 2 ? 1 : 1e-3;  // the box of a small one has no room to spare
        const Geometry geometry = moving_sphere(motion, Vec3(2, 0, 1), radius);
        const Box3 box = instance_bounds(geometry, {}).boxes.front();
        Box3 needed;
        for (int k = 0; k < 400; ++k) {
            const Vec3 point = motion.at(shutter_time(random.uniform()))
                                   .point(Vec3(2, 0, 1) + radius * random.direction());
            CAPTURE(i, k);
            REQUIRE(box.intersects(point));
            needed.extendBy(point);
        }
        REQUIRE(max_abs(box.size()) < 2 * max_abs(needed.size()));
    }
}

TEST_CASE("The box of an instance that only moves is that of its two ends") {
    Affine end;
    end.origin = {4, 0, 0};
    const Geometry geometry = moving_sphere({Affine{}, end, MotionTimes{}}, Vec3(0));
    const Box3 box = instance_bounds(geometry, {}).boxes.front();
    CHECK(max_abs(box.min - Vec3(-1)) < 1e-5);
    CHECK(max_abs(box.max - Vec3(5, 1, 1)) < 1e-5);
    const Geometry early = moving_sphere({Affine{}, end, MotionTimes{0, 1, 0, 0.25}}, Vec3(0));
    CHECK(instance_bounds(early, {}).boxes.front().max.x == Approx(2).epsilon(1e-5));
}

TEST_CASE("An instance that is singular during its motion has no box") {
    const Geometry geometry =
        moving_sphere({scaling({1, 1, 1}), scaling({1, 1, -1}), MotionTimes{}}, Vec3(0));
    CHECK(instance_bounds(geometry, {}).boxes.front().max.x == infinity);
}

TEST_CASE("A moving instance in a scene scaled by a power of two has the same hits") {
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        Scene scene;
        scene.geometry = moving_sphere(any_motion(random));
        const double k = 0x1p-11;
        const Scene small = transformed(scene, k);
        const ShutterTime time = shutter_time(random.uniform());
        const Vec3 from = 10.0 * random.in_cube();
        const Vec3 target = scene.geometry.motions[0].at(time).point(Vec3(2, 0, 1));
        const Ray ray = seen_at({from, target - from}, time);
        const Ray nearer = seen_at({k * from, k * ray.direction}, time);
        REQUIRE(first_hit(scene.geometry, key_of(0, 0), ray) ==
                first_hit(small.geometry, key_of(0, 0), nearer));
    }
}
