#include "bench/scenes/stage.h"

namespace etalon::bench {

Scene empty_scene(const Stage& stage) {
    Scene scene;
    scene.format = "generated";
    scene.camera = {stage.eye, stage.at, Vec3(0, 1, 0), stage.fov_degrees, 512, 512, 0, 1};
    scene.lights = {PointLight{stage.light, Color(1.0F)}};
    scene.materials = {Material()};
    return scene;
}

}  // namespace etalon::bench
