// Cameras with and without a lens, for tests of their rays.
#pragma once

#include "core/camera/exit_pupil.h"
#include "core/scene/camera.h"

namespace etalon::test {

enum class Lens { none, thin, system };

/// Returns a camera at the origin that looks along z, and moves if asked to. A lens of several
/// surfaces blocks some rays.
inline Camera camera_with(Lens lens, bool moves) {
    Camera camera;
    ProjectiveCamera& c = camera.projective.emplace();
    const Affine start, end{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 3}};
    if (moves) c.motion.emplace(start, end, MotionTimes{});
    if (lens == Lens::thin) c.lens_radius = 0.25;
    if (lens == Lens::system) {
        c.projection = Projection::lens_system;
        const std::vector<LensSurface> surfaces{
            {0, 0.001, 0, 0.004}, {0.05, 0.003, 1.5, 0.012}, {-0.05, 0.05, 1, 0.012}};
        c.lens = LensSystem{surfaces, 0.04, exit_pupils(surfaces, 0.04), 1};
    }
    camera.sees_motion = moves;
    return camera;
}

}  // namespace etalon::test
