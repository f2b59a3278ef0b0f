#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/scene/animated_transform.h"

namespace etalon {

enum class Projection : std::uint8_t { perspective, orthographic, environment, lens_system };

/// A surface of a lens: a spherical cap about the axis, or an aperture stop. Lengths are in metres.
struct LensSurface {
    double curvature_radius;  ///< positive if the centre is towards the film; 0 for a stop
    double thickness;         ///< distance to the next surface towards the film, or to the film
    double eta;               ///< index of refraction up to that surface; 0 for that of air
    double aperture_radius;
};

/// A lens of several surfaces in front of a film (Kolb et al. 1995, "A Realistic Camera Model for
/// Computer Graphics"). Its space is the camera's, with the film at z = 0.
struct LensSystem {
    std::vector<LensSurface> surfaces;  ///< from the scene to the film
    double film_diagonal;               ///< metres
    /// Rectangles in the plane of the last surface that contain all points through which light
    /// reaches a point of the film. There is one for each of equal intervals of the film's x axis,
    /// from its centre to the distance of a corner.
    std::vector<Imath::Box2d> exit_pupils;
    /// Exposure at the centre of the film, per unit of radiance and area of its exit pupil.
    double exposure;
};

/// A rectangle in the plane z = 1 of a camera's space. It is mirrored where the right edge is on
/// the left, or the top below.
struct ImageWindow {
    double left, right, bottom, top;

    double width() const { return right - left; }
    double height() const { return top - bottom; }
};

/// Returns the window about the axis of some aspect ratio whose shorter side is twice `half_side`.
ImageWindow centred_window(double half_side, double aspect);

/// A camera in a space of its own: x to the right, y up, looking along z. Any affine map, mirroring
/// or not, takes it to world space.
struct ProjectiveCamera {
    Projection projection = Projection::perspective;
    Affine to_world;  ///< for a moving camera: at the time at which the shutter opens
    /// The part of the plane z = 1 that the image shows, if it is fixed; unused by
    /// Projection::environment. If it is not, it is the centred window of `half_side` and the
    /// image's aspect ratio. With a `lens` only its diagonal is fixed, as the film's is.
    std::optional<ImageWindow> fixed_window{};
    double half_side = 1;
    double lens_radius = 0;
    double focal_distance = 1;                  ///< z of the plane in focus
    std::optional<AnimatedTransform> motion{};  ///< set if the camera moves
    std::optional<LensSystem> lens{};           ///< if set, the window is approximate

    /// Returns the part of the plane z = 1 that an image of some width and height shows.
    ImageWindow window(const Imath::V2i& resolution) const;
};

/// A pinhole or thin-lens camera. The view plane passes through `at`.
struct Camera {
    Vec3 eye{0, 0, 0}, at{0, 0, -1}, up{0, 1, 0};
    double fov_degrees = 45;   ///< full vertical field of view
    double aperture = 0;       ///< lens diameter in pixel heights on the view plane; 0 is a pinhole
    double focal = 1;          ///< distance of the plane in focus, in units of |at - eye|
    bool stretched = false;    ///< the field of view is also the horizontal one, so that pixels
                               ///< need not be square
    bool sees_motion = false;  ///< the camera or the scene moves: rays have different times
    /// If set, it generates the rays; then only `eye`, `at` and `up` of the above are used.
    std::optional<ProjectiveCamera> projective{};
};

}  // namespace etalon
