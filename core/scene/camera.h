#pragma once

#include <cstdint>
#include <optional>

#include "core/scene/animated_transform.h"

namespace etalon {

enum class Projection : std::uint8_t { perspective, orthographic, environment };

/// A camera by its own space: x to the right, y up, looking along z. Any affine map takes it to the
/// world, one that mirrors too.
struct ProjectiveCamera {
    Projection projection = Projection::perspective;
    Affine to_world;      ///< of one that moves: where the shutter opens
    Imath::Box2d window;  ///< the image in the plane z = 1; of no effect on an environment
    double lens_radius = 0;
    double focal_distance = 1;                  ///< z of the plane in focus
    std::optional<AnimatedTransform> motion{};  ///< how it moves, if it does
};

/// A pinhole or thin-lens camera. The view plane passes through `at`.
struct Camera {
    Vec3 eye, at, up;
    double fov_degrees = 45;   ///< full vertical field of view
    double aperture = 0;       ///< lens diameter in pixel heights on the view plane; 0 is a pinhole
    double focal = 1;          ///< distance of the plane in focus, in units of |at - eye|
    bool stretched = false;    ///< the field of view is the horizontal one, too: pixels need not be
                               ///< square, as otherwise they are
    bool sees_motion = false;  ///< it moves, or something of the scene: rays are of many times
    /// Set: rays are made by it, and of all the above only `eye`, `at` and `up` say something.
    std::optional<ProjectiveCamera> projective{};
};

}  // namespace etalon
