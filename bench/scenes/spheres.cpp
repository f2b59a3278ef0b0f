#include "bench/scenes/bench_families.h"
#include "bench/scenes/stage.h"
#include "core/numerics/random.h"

namespace etalon::bench {

/// The radius decreases so that a ray passes about the same number of spheres for every count.
Scene spheres(std::size_t count) {
    Scene scene = empty_scene();
    Random random(2);
    const double radius = 0.5 / std::sqrt(static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 place = random.in_cube();
        scene.geometry.add(Sphere{place, radius * random.uniform(0.5, 1.5)}, 0);
    }
    return scene;
}

}  // namespace etalon::bench
