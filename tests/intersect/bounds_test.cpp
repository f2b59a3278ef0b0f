#include "core/intersect/kernels.h"
#include "tests/catch.h"
#include "tests/intersect/rays_at_shapes.h"

using namespace etalon;

TEST_CASE("bounds: given a hit, then its point is within them but for a few roundings") {
    for (const ShapeCase& shape : shape_cases()) {
        const Box3 box = primitive_bounds(shape.scene.geometry, 0);
        Random random(10);
        for (int i = 0; i < 3000; ++i) {
            const Ray ray = aimed_ray(shape, i, random).ray;
            const double t = primitive_first_hit(shape.scene.geometry, 0, RayQuery(ray));
            if (!(t <= infinity)) continue;
            const Vec3 point = ray.origin + t * ray.direction;
            const double few = 32 * 0x1p-53;
            for (int k = 0; k < 3; ++k) {
                const double travelled = max_abs(ray.origin) + t * max_abs(ray.direction);
                const double slack = few * (travelled + max_abs(shape.centre) + shape.size);
                CAPTURE(shape.name, i, k, point[k], box.min[k], box.max[k]);
                REQUIRE(point[k] >= box.min[k] - slack);
                REQUIRE(point[k] <= box.max[k] + slack);
            }
        }
    }
}

TEST_CASE("bounds: given a sum that a double cannot hold, then the whole bounds hold it") {
    Scene scene;
    const double far = 0x1p53;  // whose neighbours are 1 below and 2 above
    scene.geometry.add(Sphere{Vec3(far), 1}, 0);
    scene.geometry.add(Box{Vec3(far), Vec3(far + 2)}, 0);
    CHECK(primitive_bounds(scene.geometry, 0).max.x == far);
    CHECK(whole_bounds(scene.geometry, 0).max.x > far + 1);
    CHECK(whole_bounds(scene.geometry, 0).min.x <= far - 1);
    CHECK(whole_bounds(scene.geometry, 1) == primitive_bounds(scene.geometry, 1));
}

TEST_CASE("bounds: given points all over a bounded shape, then every face of the box is reached") {
    for (const ShapeCase& shape : shape_cases()) {
        const Box3 box = primitive_bounds(shape.scene.geometry, 0);
        if (!is_finite(box.min)) continue;
        Box3 seen;
        Random random(11);
        for (int i = 0; i < 20000; ++i) {
            const AimedRay aimed = aimed_ray(shape, i, random);
            const double t = primitive_first_hit(shape.scene.geometry, 0, RayQuery(aimed.ray));
            if (t <= infinity)
                seen.extendBy(surface_at(shape.scene.geometry, aimed.ray, {t, 0}).position);
        }
        const double tolerance = 0.02 * shape.size;
        CAPTURE(shape.name, box.min, seen.min, box.max, seen.max);
        REQUIRE(max_abs(seen.min - box.min) < tolerance);
        REQUIRE(max_abs(seen.max - box.max) < tolerance);
    }
}
