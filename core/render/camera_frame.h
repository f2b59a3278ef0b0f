#pragma once

#include <optional>

#include "core/scene/camera.h"

namespace etalon {

/// Data from which a camera's rays are made. A place on the image is the point axis + (x, -y) /
/// pixel_size; in space it is eye + x u + y v - to_eye, on the image plane.
struct CameraFrame {
    Projection projection = Projection::perspective;
    Vec3 eye;
    Vec3 u, v;           ///< u right, v up
    Vec3 to_eye;         ///< from the image plane back to the eye, along the axis of view
    Vec3 n;              ///< unit vector backwards, perpendicular to the image plane
    Vec2 axis;           ///< pixel through which the axis of view passes
    Vec2 pixel_size;     ///< size on the image plane, in units of u and v
    double lens_radius;  ///< in units of u and v; 0 is a pinhole
    double focal;        ///< distance of the plane in focus, in units of to_eye

    Imath::M44d world_to_camera;
    std::optional<Imath::M44d> world_to_ndc;

    /// Moves the data for rays to the current position of a projective camera's own space.
    void move_rays(const Affine& to_world) {
        eye = to_world.origin;
        u = to_world.x, v = to_world.y;
        to_eye = -to_world.z;
    }
};

/// Returns the frame of `camera`; `resolution` is the width and height of the image in pixels.
CameraFrame camera_frame(const Camera& camera, const Imath::V2i& resolution);

}  // namespace etalon
