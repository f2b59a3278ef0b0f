#include "core/render/camera_frame.h"

#include <cmath>
#include <numbers>

#include "core/numerics/rounding.h"

namespace etalon {
namespace {

/// Returns the matrix, for row vectors, that maps a point to the dot products of its offset from
/// `origin` with x, y and z.
Imath::M44d to_coordinates(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& origin) {
    return {x.x,
            y.x,
            z.x,
            0,  //
            x.y,
            y.y,
            z.y,
            0,  //
            x.z,
            y.z,
            z.z,
            0,  //
            -origin.dot(x),
            -origin.dot(y),
            -origin.dot(z),
            1};
}

CameraFrame pinhole_frame(const Camera& c, const Vec2& size) {
    CameraFrame frame;
    frame.eye = c.eye;
    frame.focal = c.focal;
    const Vec3 back = c.eye - c.at;
    const double distance = std::sqrt(back.dot(back));
    auto& [projection, eye, u, v, to_eye, n, axis, pixel_size, lens_radius, focal, to_camera,
           to_ndc] = frame;
    n = back / distance;
    to_eye = distance * n;
    const Vec3 right = to_unit_magnitude(to_unit_magnitude(c.up).cross(n));
    const double length = std::sqrt(right.dot(right));
    orthonormal_basis(n, u, v);  // any basis will do for an `up` along the view direction
    if (length > 0) u = right / length;
    v = n.cross(u);
    const double half_angle = c.fov_degrees / 2 * (std::numbers::pi / 180);
    const double plane_height = 2 * distance * std::tan(half_angle);
    pixel_size = Vec2(plane_height / (c.stretched ? size.x : size.y), plane_height / size.y);
    axis = size / 2;
    lens_radius = c.aperture * pixel_size.y / 2;
    to_camera = to_coordinates(u, v, n, eye);
    const Vec2 half_size = axis * pixel_size;
    const Imath::M44d project(distance / half_size.x, 0, 0, 0,  //
                              0, distance / half_size.y, 0, 0,  //
                              0, 0, -1, -1,                     //
                              0, 0, 0, 0);
    to_ndc = to_camera * project;
    return frame;
}

/// Returns the projection of camera space, with z backwards, to [-1,1]^2 over the window. A point's
/// third coordinate becomes 1.
Imath::M44d projection_matrix(Projection projection, const ImageWindow& window) {
    const Vec2 size(window.width(), window.height());
    const Vec2 scale = Vec2(2) / size;
    const Vec2 offset = Vec2(window.left + window.right, window.bottom + window.top) / size;
    if (projection == Projection::orthographic) {
        return {scale.x,   0,         0, 0,  //
                0,         scale.y,   0, 0,  //
                0,         0,         0, 0,  //
                -offset.x, -offset.y, 1, 1};
    }
    return {scale.x,  0,        0,  0,   //
            0,        scale.y,  0,  0,   //
            offset.x, offset.y, -1, -1,  //
            0,        0,        0,  0};
}

/// Returns the frame of a camera with a space of its own. Lengths are those of that space; a
/// point's distance along the view is measured in world space.
CameraFrame projective_frame(const ProjectiveCamera& c, const Imath::V2i& resolution) {
    const Vec2 size(resolution);
    const ImageWindow window = c.window(resolution);
    const Affine& m = c.to_world;
    const Vec3 yz = m.y.cross(m.z), zx = m.z.cross(m.x), xy = m.x.cross(m.y);
    const double volume = m.determinant();
    CameraFrame frame{c.projection,     m.origin, m.x, m.y, -m.z, {}, {}, {}, 0,
                      c.focal_distance, {},       {}};
    frame.n = normalized(xy) * (volume > 0 ? -1.0 : 1.0);
    frame.world_to_camera = to_coordinates(yz / volume, zx / volume, -xy / volume, m.origin);
    frame.pixel_size = Vec2(window.width(), window.height()) / size;
    frame.axis = Vec2(-window.left, window.top) / frame.pixel_size;
    if (c.projection == Projection::environment) {
        frame.pixel_size = Vec2(1) / size;
    } else {
        frame.lens_radius = c.lens_radius;
        if (c.lens) return frame;
        frame.world_to_ndc = frame.world_to_camera * projection_matrix(c.projection, window);
    }
    return frame;
}

}  // namespace

CameraFrame camera_frame(const Camera& camera, const Imath::V2i& resolution) {
    return camera.projective ? projective_frame(*camera.projective, resolution)
                             : pinhole_frame(camera, Vec2(resolution));
}

}  // namespace etalon
