#include "bench/scenes/bench_families.h"
#include "bench/scenes/stage.h"

namespace etalon::bench {

/// No split separates them, and a builder must still end its recursion.
Scene duplicates(std::size_t count) {
    Scene scene = empty_scene();
    scene.geometry.vertices = {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)};
    for (std::size_t i = 0; i < count; ++i) scene.geometry.add(Triangle{{0, 1, 2}}, 0);
    return scene;
}

}  // namespace etalon::bench
