#include "bench/scenes/bench_families.h"
#include "bench/scenes/needles.h"
#include "bench/scenes/stage.h"

namespace etalon::bench {

/// Thin triangles whose boxes are far larger than the triangles.
Scene slivers(std::size_t count) {
    Scene scene = empty_scene({.eye = {1.5, 1.1, 1.9}});
    Random random(5);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 place = random.in_cube();
        add_needle(scene, place, random.direction(), 0.24, 0.002, random);
    }
    return scene;
}

}  // namespace etalon::bench
