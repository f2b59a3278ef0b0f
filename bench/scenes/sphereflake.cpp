#include "bench/scenes/bench_families.h"
#include "bench/scenes/sphereflake_spheres.h"
#include "bench/scenes/stage.h"

namespace etalon::bench {

Scene sphereflake(std::size_t depth) {
    Scene scene = empty_scene({.eye = {2.8, 2.3, 3.5}, .at = {0, 0.2, 0}});
    for (const Sphere& sphere : sphereflake_spheres(depth)) scene.geometry.add(sphere, 0);
    return scene;
}

}  // namespace etalon::bench
