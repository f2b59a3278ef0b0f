#include "core/render/camera_rays.h"

#include <cmath>
#include <numbers>

namespace etalon {
namespace {

/// Area-preserving map of the unit square to the unit disk (Shirley & Chiu 1997, "A Low Distortion
/// Map Between Disk and Square").
Vec2 concentric_disk(const Vec2& p) {
    const double a = 2 * p.x - 1, b = 2 * p.y - 1;
    if (a == 0 && b == 0) return Vec2(0);
    const bool wide = std::abs(a) > std::abs(b);
    const double radius = wide ? a : b;
    const double angle = wide ? std::numbers::pi / 4 * (b / a)
                              : std::numbers::pi / 2 - std::numbers::pi / 4 * (a / b);
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

CameraRays::CameraRays(const Camera& c, const Imath::V2i& resolution)
    : eye_(c.eye), width_(resolution.x), height_(resolution.y), focal_(c.focal) {
    const Vec3 back = c.eye - c.at;
    distance_ = std::sqrt(back.dot(back));
    n_ = back / distance_;
    const Vec3 right = c.up.cross(n_);
    const double length = std::sqrt(right.dot(right));
    Vec3 v;
    orthonormal_basis(n_, u_, v);  // for an `up` along the view direction: any will do
    if (length > 0) u_ = right / length;
    v_ = n_.cross(u_);
    const double half_angle = c.fov_degrees / 2 * (std::numbers::pi / 180);
    const double plane_height = 2 * distance_ * std::tan(half_angle);
    pixel_size_ = Vec2(plane_height / (c.stretched ? width_ : height_), plane_height / height_);
    lens_radius_ = c.aperture * pixel_size_.y / 2;
}

Ray CameraRays::ray(const Vec2& pixel, const Vec2& lens) const {
    const double x = (pixel.x - width_ / 2) * pixel_size_.x;
    const double y = (height_ / 2 - pixel.y) * pixel_size_.y;
    Vec3 direction = x * u_ + y * v_ - distance_ * n_;
    Vec3 origin = eye_;
    if (has_lens()) {
        const Vec2 disk = concentric_disk(lens) * lens_radius_;
        const Vec3 offset = disk.x * u_ + disk.y * v_;
        origin += offset;
        direction = direction * focal_ - offset;
    }
    return {origin, normalized(direction)};
}

Imath::M44d CameraRays::world_to_camera() const {
    return {u_.x,          v_.x,          n_.x,          0,  //
            u_.y,          v_.y,          n_.y,          0,  //
            u_.z,          v_.z,          n_.z,          0,  //
            -eye_.dot(u_), -eye_.dot(v_), -eye_.dot(n_), 1};
}

Imath::M44d CameraRays::world_to_ndc() const {
    const double half_width = width_ / 2 * pixel_size_.x;
    const double half_height = height_ / 2 * pixel_size_.y;
    const Imath::M44d project(distance_ / half_width, 0, 0, 0,   //
                              0, distance_ / half_height, 0, 0,  //
                              0, 0, -1, -1,                      //
                              0, 0, 0, 0);
    return world_to_camera() * project;
}

}  // namespace etalon
