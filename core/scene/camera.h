#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/scene/animated_transform.h"

namespace etalon {

enum class Projection : std::uint8_t { perspective, orthographic, environment, lens_system };

/// A surface of a lens: a part of a sphere about the axis, or a stop. Lengths in metres.
struct LensSurface {
    double curvature_radius;  ///< positive where the centre is towards the film; 0: a stop
    double thickness;         ///< distance to the next surface towards the film, or to the film
    double eta;               ///< index of refraction up to there; 0: that of air
    double aperture_radius;
};

/// A lens of several surfaces before a film (Kolb et al. 1995, "A Realistic Camera Model for
/// Computer Graphics"). Its space is the camera's, with the film at z = 0.
struct LensSystem {
    std::vector<LensSurface> surfaces;  ///< from the scene to the film
    double film_diagonal;               ///< metres
    /// Rectangles of the plane of the last surface that hold all points through which light
    /// reaches a point of the film, of equal parts of the way from its middle along x to its
    /// corner.
    std::vector<Imath::Box2d> exit_pupils;
    /// Light at the middle of the film, per unit of radiance and of its exit pupil's rectangle.
    double exposure;
};

/// A camera by its own space: x to the right, y up, looking along z. Any affine map takes it to the
/// world, one that mirrors too.
struct ProjectiveCamera {
    Projection projection = Projection::perspective;
    Affine to_world;      ///< of one that moves: where the shutter opens
    Imath::Box2d window;  ///< the image in the plane z = 1; of no effect on an environment
    double lens_radius = 0;
    double focal_distance = 1;                  ///< z of the plane in focus
    std::optional<AnimatedTransform> motion{};  ///< how it moves, if it does
    std::optional<LensSystem> lens{};  ///< of a camera with one; `window` is about what it shows
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
