// Tests specific to the Embree backends.
#include <tbb/task_scheduler_observer.h>

#include <atomic>
#include <cfloat>

#include "core/intersect/kernels.h"
#include "core/parallel/parallel.h"
#include "embree_backend/embree_backends.h"
#include "tests/backends/scenes.h"
#include "tests/backends/test_rays.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Counts how often a thread other than this one joins in the work of this one.
class Helpers : public tbb::task_scheduler_observer {
  public:
    Helpers() { observe(true); }
    void on_scheduler_entry(bool is_worker) override { count_ += is_worker ? 1 : 0; }
    int count() const { return count_; }

  private:
    std::atomic<int> count_ = 0;
};

/// Created before any of oneTBB's threads and never destroyed: sanitizers report oneTBB's handling
/// of observers as a race or a leak.
const Helpers& all_helpers = *new Helpers;

/// Returns the number of threads that joined in a build, the smallest of three builds: a thread
/// that was woken before may join late, but not every time.
int helpers_of(const Backend& backend, const Scene& scene) {
    int least = std::numeric_limits<int>::max();
    for (int i = 0; i < 3; ++i) {
        const int before = all_helpers.count();
        backend.build(scene.geometry);
        least = std::min(least, all_helpers.count() - before);
    }
    return least;
}

bool keeps_denormals() {
    volatile double least = DBL_MIN;
    return least / 2 != 0;
}

/// Several objects with five instances each: rotated, stretched, mirrored. The last object may
/// contain a box, for which Embree has no geometry.
Scene scene_of_instances(bool has_box) {
    Scene scene = make_scene("mix", 20);
    Geometry& world = scene.geometry;
    for (const char* family : {"triangles", "spheres", "polygons"}) {
        world.objects.push_back(make_scene(family, 100).geometry);
    }
    if (has_box) world.objects.back().add(Box{Vec3(-0.5), Vec3(0.5)}, 0);
    Random random(3);
    for (std::uint32_t i = 0; i < 15; ++i) {
        const Affine map{random.in_cube(), random.in_cube(), random.in_cube(),
                         3.0 * random.in_cube()};
        world.instances.emplace_back(map, i % 3);
    }
    return scene;
}

/// Adds the six sides of a rotated cube, each of two triangles.
void add_room(Scene& scene, double half_side) {
    const Vec3 x = half_side * normalized(Vec3(3, 1, 2));
    const Vec3 y = half_side * normalized(x.cross(Vec3(1, 5, -2)));
    const Vec3 z = half_side * normalized(x.cross(y));
    for (const auto& [a, b, c] : {std::array{x, y, z}, std::array{y, z, x}, std::array{z, x, y}}) {
        for (const double side : {-1.0, 1.0}) {
            const auto first = static_cast<std::uint32_t>(scene.geometry.vertices.size());
            for (const Vec3& corner : {a + b, a - b, -a - b, -a + b}) {
                scene.geometry.vertices.push_back(corner + side * c);
            }
            scene.geometry.add(Triangle{{first, first + 1, first + 2}}, 0);
            scene.geometry.add(Triangle{{first, first + 2, first + 3}}, 0);
        }
    }
}

}  // namespace

TEST_CASE("Given a limit of one thread, Embree builds on one", "[backends][embree]") {
    const Scene scene = make_scene("spheres", 100000);
    for (const Backend& backend : embree_backends()) {
        INFO("backend " << backend.name);
        const ThreadLimit limit(1);
        CHECK(helpers_of(backend, scene) == 0);
    }
}

TEST_CASE("Given an Embree build, the caller's arithmetic stays what it was",
          "[backends][embree]") {
    const Scene scene = make_scene("mix", 1000);
    for (const Backend& backend : embree_backends()) {
        const auto intersector = backend.build(scene.geometry);
        CHECK(keeps_denormals());
        intersector->closest({Vec3(0), Vec3(1)});
        CHECK(keeps_denormals());
    }
}

TEST_CASE("Given an Embree backend, it reports its memory and instruction set",
          "[backends][embree]") {
    const Scene scene = make_scene("triangles", 10000);
    for (const Backend& backend : embree_backends()) {
        INFO("backend " << backend.name);
        const auto intersector = backend.build(scene.geometry);
        CHECK(intersector->memory_bytes() > 30 * 10000);
        CHECK(intersector->memory_bytes() < 300 * 10000);
        CHECK(!intersector->isa().empty());
    }
}

TEST_CASE("Given triangles or spheres, the backend embree needs little memory for each",
          "[backends][embree]") {
    const auto bytes = [](const char* family) {
        const Scene scene = make_scene(family, 20000);
        const auto intersector = backend_named("embree").build(scene.geometry);
        return static_cast<double>(intersector->memory_bytes()) / 20000;
    };
    CHECK(bytes("triangles") < 85);
    CHECK(bytes("spheres") < 85);
}

TEST_CASE("Given rays of moderate length, Embree's own shapes hit nearly what the kernels hit",
          "[backends][embree]") {
    for (const char* family : {"spheres", "triangles", "polygons", "mix", "one_sided"}) {
        const Scene scene = make_scene(family, 300);
        const auto exact = backend_named("none").build(scene.geometry);
        const auto floats = backend_named("embree-builtin").build(scene.geometry);
        Random random(5);
        int different = 0;
        constexpr int count = 20000;
        for (int i = 0; i < count; ++i) {
            const Vec3 origin = 3.0 * random.direction();
            const Ray ray{origin, random.in_cube() - origin};
            const auto a = exact->closest(ray), b = floats->closest(ray);
            const bool same =
                a && b ? a->primitive == b->primitive && std::abs(a->t - b->t) < 1e-4 : !a && !b;
            if (!same || b.has_value() != floats->occluded(ray)) ++different;
        }
        INFO(family);
        CHECK(different <= count / 2000);
    }
}

TEST_CASE("Given shadow rays to a light with a shape, Embree's own does not occlude itself",
          "[backends][embree]") {
    Scene scene;
    scene.geometry.add(Sphere{{5, 6, 7}, 0.5}, 0);
    scene.geometry.add(Box{{-9, -9, -9}, {9, 9, -8}}, 0);
    const auto floats = backend_named("embree-builtin").build(scene.geometry);
    Random random(11);
    int occluded = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 from(random.uniform(-9, 9), random.uniform(-9, 9), -8);
        const Vec3 outward = random.direction(), to = Vec3(5, 6, 7) + 0.5 * outward;
        if (outward.dot(normalized(from - to)) < 0.1) continue;  // hidden, or nearly
        Ray ray{from, to - from};
        ray.tmin = 1e-3;
        ray.tmax = 1 - 0x1p-32;  // as all shadow rays
        occluded += floats->occluded(ray) ? 1 : 0;
    }
    CHECK(occluded == 0);
}

TEST_CASE("Given instances, Embree's own hit nearly what the kernels hit", "[backends][embree]") {
    for (const bool has_solids : {false, true}) {
        const Scene scene = scene_of_instances(has_solids);
        const auto exact = backend_named("none").build(scene.geometry);
        const auto floats = backend_named("embree-builtin").build(scene.geometry);
        Random random(5);
        int different = 0, of_instances = 0;
        constexpr int count = 20000;
        for (int i = 0; i < count; ++i) {
            const Vec3 origin = 9.0 * random.direction();
            const Ray ray{origin, 3.0 * random.in_cube() - origin};
            const auto a = exact->closest(ray), b = floats->closest(ray);
            const bool same = a && b ? a->primitive == b->primitive && a->instance == b->instance &&
                                           std::abs(a->t - b->t) < 1e-4
                                     : !a && !b;
            of_instances += a && a->instance != no_index ? 1 : 0;
            if (!same || b.has_value() != floats->occluded(ray)) ++different;
        }
        INFO("solids: " << has_solids);
        CHECK(of_instances > count / 3);
        CHECK(different <= count / 1000);
    }
}

TEST_CASE("Given instances tiny beside the scene, Embree's own hit nearly what the kernels hit",
          "[backends][embree]") {
    Scene scene;
    scene.geometry.add(Sphere{{0, -2000, 0}, 1000}, 0);
    scene.geometry.objects.push_back(make_scene("triangles", 100).geometry);
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const Vec3 at = random.in_cube();
        scene.geometry.instances.emplace_back(Affine{{0.02, 0, 0}, {0, 0.02, 0}, {0, 0, 0.02}, at},
                                              0);
    }
    const auto exact = backend_named("bvh").build(scene.geometry);
    const auto floats = backend_named("embree-builtin").build(scene.geometry);
    int different = 0, hits = 0;
    constexpr int count = 20000;
    for (int i = 0; i < count; ++i) {
        const Vec3 near = scene.geometry.instances[random.index(200)].origin;
        const Vec3 from = near + 0.05 * random.direction();
        const Ray ray{from, near + 0.01 * random.in_cube() - from};
        const auto a = exact->closest(ray), b = floats->closest(ray);
        const bool same = a && b && a->primitive == b->primitive && a->instance == b->instance;
        hits += a ? 1 : 0;
        different += same || (!a && !b) ? 0 : 1;
    }
    CHECK(hits > count / 3);
    CHECK(different <= count / 20);
}

TEST_CASE("Given walls around tiny instances, Embree's own are not met by rays that leave them",
          "[backends][embree]") {
    Scene scene;
    add_room(scene, 50);
    scene.geometry.objects.push_back(make_scene("triangles", 10).geometry);
    Random random(3);
    for (int i = 0; i < 20; ++i) {
        const Affine map{{0.002, 0, 0}, {0, 0.002, 0}, {0, 0, 0.002}, 10.0 * random.in_cube()};
        scene.geometry.instances.emplace_back(map, 0);
    }
    const auto exact = backend_named("bvh").build(scene.geometry);
    const auto floats = backend_named("embree-builtin").build(scene.geometry);
    int met = 0, left = 0;
    for (int i = 0; i < 20000; ++i) {
        const Ray ray{10.0 * random.in_cube(), random.direction()};
        const auto wall = exact->closest(ray);
        if (!wall || wall->instance != no_index) continue;
        const SurfacePoint point = surface_at(scene.geometry, ray, *wall);
        const Vec3 inward = point.normal.dot(ray.direction) < 0 ? point.normal : -point.normal;
        const auto again = floats->closest(spawn_ray(point, inward + random.direction()));
        met += again && again->instance == no_index && again->t < 1e-3 ? 1 : 0;
        ++left;
    }
    CHECK(left > 19000);
    CHECK(met <= left / 10000);
}
