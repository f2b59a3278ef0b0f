// Camera, light and material of every benchmark scene.
#pragma once

#include "core/scene/scene.h"

namespace etalon::bench {

/// Positions of the camera and of the only light.
struct Stage {
    Vec3 eye{2.2, 1.6, 2.8};  ///< by default all of the cube from -1 to 1 is visible
    Vec3 at{0};
    double fov_degrees = 45;
    Vec3 light{3, 5, 4};
};

/// Returns a scene with material 0, a light and a camera, but no shapes.
Scene empty_scene(const Stage& stage = {});

}  // namespace etalon::bench
