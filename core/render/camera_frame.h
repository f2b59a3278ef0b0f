#pragma once

#include <optional>

#include "core/scene/camera.h"

namespace etalon {

/// What a camera's rays are made from. A place of the image is the point axis + (x, -y) /
/// pixel_size, and in space eye + x u + y v - to_eye on the image plane.
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

    /// Moves what rays are made from to where a projective camera's own space is now.
    void move_rays(const Affine& to_world) {
        eye = to_world.origin;
        u = to_world.x, v = to_world.y;
        to_eye = -to_world.z;
    }
};

/// The frame of `camera`; `resolution` is width and height of the image in pixels.
CameraFrame camera_frame(const Camera& camera, const Imath::V2i& resolution);

}  // namespace etalon
