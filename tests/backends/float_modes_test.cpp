// A caller may have enabled flush-to-zero and denormals-are-zero: no result depends on it.
#if defined(__SSE2__)
#include <immintrin.h>

#include "tests/backends/scenes.h"
#include "tests/backends/test_rays.h"
#include "tests/backends/tracers.h"
#include "tests/catch.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Enables flush-to-zero and denormals-are-zero during its lifetime.
class FlushedDenormals {
  public:
    FlushedDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040U); }
    ~FlushedDenormals() { _mm_setcsr(before_); }
    FlushedDenormals(const FlushedDenormals&) = delete;
    FlushedDenormals& operator=(const FlushedDenormals&) = delete;

  private:
    unsigned before_;
};

}  // namespace

TEST_CASE("Given a processor that flushes denormals, every exact backend gives the same hits",
          "[backends]") {
    for (const SceneFamily& family : scene_families()) {
        const Scene scene = family.make(200);
        Random random(9);
        const std::vector<Ray> rays = make_rays(scene, 1500, random);
        std::vector<std::optional<Hit>> expected;
        for (const Ray& ray : rays) expected.push_back(brute_force(scene, ray));
        for (const Backend& backend : exact_backends()) {
            const auto intersector = backend.build(scene.geometry);
            std::size_t different = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const FlushedDenormals flushed;
                different += difference(*intersector, rays[i], expected[i]) != "";
            }
            INFO(family.name << " by " << backend.name);
            CHECK(different == 0);
        }
    }
}
#endif
