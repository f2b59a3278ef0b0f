#pragma once

#include "core/scene/scene.h"

namespace etalon {

/// Has the scene rendered by the rules of the Standard Procedural Databases (Haines 1987): one ray
/// through each pixel corner, a mirrored one from all glass.
inline void apply_spd_rules(Scene& scene) {
    scene.samples_per_pixel = 0;
    scene.camera.pixel_rays = PixelRays::shared_corners;
    scene.whitted.mirror_all_glass = true;
}

}  // namespace etalon
