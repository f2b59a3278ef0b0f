// What is particular to the Embree backends.
#include <tbb/task_scheduler_observer.h>

#include <atomic>
#include <cfloat>

#include "core/intersect/kernels.h"
#include "core/parallel/parallel.h"
#include "embree_backend/backends.h"
#include "tests/backends/contenders.h"
#include "tests/backends/rays.h"
#include "tests/backends/scenes.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Counts the threads other than the caller's that take up work while it exists.
class WorkerCount : public tbb::task_scheduler_observer {
  public:
    WorkerCount() { observe(true); }
    ~WorkerCount() override { observe(false); }
    void on_scheduler_entry(bool is_worker) override { workers_ += is_worker ? 1 : 0; }
    int workers() const { return workers_; }

  private:
    std::atomic<int> workers_{0};
};

bool keeps_denormals() {
    volatile double least = DBL_MIN;
    return least / 2 != 0;
}

}  // namespace

TEST_CASE("Given a limit of one thread, Embree builds on one", "[backends][embree]") {
    const Scene scene = make_scene("spheres", 100000);
    for (const Backend& backend : embree_backends()) {
        INFO("backend " << backend.name);
        const ThreadLimit limit(1);
        const WorkerCount count;
        const auto intersector = backend.build(scene);
        CHECK(count.workers() == 0);
    }
}

TEST_CASE("Given an Embree build, the caller's arithmetic stays what it was",
          "[backends][embree]") {
    const Scene scene = make_scene("mix", 1000);
    for (const Backend& backend : embree_backends()) {
        const auto intersector = backend.build(scene);
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
        const auto intersector = backend.build(scene);
        CHECK(intersector->memory_bytes() > 30 * 10000);
        CHECK(intersector->memory_bytes() < 300 * 10000);
        CHECK(!intersector->isa().empty());
    }
}

TEST_CASE("Given rays of moderate length, Embree's own shapes hit nearly what the kernels hit",
          "[backends][embree]") {
    for (const char* family : {"spheres", "triangles", "polygons", "mix", "one_sided"}) {
        const Scene scene = make_scene(family, 300);
        const auto exact = backend_named("none").build(scene);
        const auto floats = backend_named("embree-builtin").build(scene);
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
