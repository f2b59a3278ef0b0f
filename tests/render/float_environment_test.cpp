#include "core/parallel/float_environment.h"

#include <atomic>
#include <limits>

#include "app/common/backends.h"
#include "core/parallel/parallel.h"
#include "tests/catch.h"
#include "tests/render/test_scenes.h"

using namespace etalon;

namespace {

/// Returns whether denormals are enabled: half of the smallest normal number is not 0.
bool denormals_live() {
    volatile double smallest = std::numeric_limits<double>::min();
    volatile float smallest_f = std::numeric_limits<float>::min();
    return smallest / 2 > 0 && smallest_f / 2 > 0;
}

}  // namespace

TEST_CASE("Building with any backend leaves denormals alone, on every thread", "[render]") {
    Scene scene = test::mixed_scene();
    for (int i = 0; i < 20000; ++i)
        scene.geometry.add(Sphere{Vec3(i, 0, 0), 0.25}, 0);  // work for threads
    for (const Backend& backend : all_backends()) {
        INFO(backend.name);
        const auto intersector = backend.build(scene.geometry);
        CHECK(denormals_live());
        std::atomic<int> dead = 0;
        parallel_for(256, 1, [&](std::size_t, std::size_t) { dead += denormals_live() ? 0 : 1; });
        CHECK(dead == 0);
    }
}
