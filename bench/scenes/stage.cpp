#include "bench/scenes/stage.h"

namespace etalon::bench {

Scene empty_scene(const Stage& stage) {
    Scene scene;
    scene.format = "generated";
    scene.camera = {
        .eye = stage.eye, .at = stage.at, .up = {0, 1, 0}, .fov_degrees = stage.fov_degrees};
    scene.whitted().lights.emplace_back(PointLight{stage.light, Color(1.0F)});
    scene.whitted().materials = {Material()};
    return scene;
}

}  // namespace etalon::bench
