#include "core/render/camera_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/numerics/instruction_sets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/camera_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/numerics/vec_lanes-inl.h"

#ifndef ETALON_CAMERA_RAYS_ONCE
#define ETALON_CAMERA_RAYS_ONCE
namespace etalon {

/// Rays in the making, so many that they stay in the fastest cache.
struct RayChunk {
    static constexpr std::size_t most = 64;

    std::size_t count;
    std::array<Vec2, most> pixels, on_lens;  ///< the latter on a disk of the lens' radius
    std::array<Vec3, most> origins, directions;
};

}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

void make_rays(const CameraFrame& c, RayChunk& rays) {
    const DoubleTag tag;
    const Vec3Lanes eye = broadcast(c.eye), u = broadcast(c.u), v = broadcast(c.v),
                    to_plane = broadcast(c.distance * c.n);
    const Doubles half_width = broadcast(c.width / 2), half_height = broadcast(c.height / 2),
                  width = broadcast(c.pixel_size.x), height = broadcast(c.pixel_size.y),
                  focal = broadcast(c.focal);
    for (std::size_t i = 0; i < rays.count; i += hn::Lanes(tag)) {
        const Vec2Lanes pixel = load(&rays.pixels[i]);
        const Doubles x = (pixel.x - half_width) * width, y = (half_height - pixel.y) * height;
        Vec3Lanes origin = eye, direction = x * u + y * v - to_plane;
        if (c.lens_radius > 0) {
            const Vec2Lanes disk = load(&rays.on_lens[i]);
            const Vec3Lanes offset = disk.x * u + disk.y * v;
            origin = eye + offset;
            direction = focal * direction - offset;
        }
        store(origin, &rays.origins[i]);
        store(normalized(direction), &rays.directions[i]);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(make_rays);

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

CameraRays::CameraRays(const Camera& c, const Imath::V2i& resolution) {
    frame_.eye = c.eye;
    frame_.width = resolution.x;
    frame_.height = resolution.y;
    frame_.focal = c.focal;
    const Vec3 back = c.eye - c.at;
    auto& [eye, u, v, n, distance, pixel_size, width, height, lens_radius, focal] = frame_;
    distance = std::sqrt(back.dot(back));
    n = back / distance;
    const Vec3 right = c.up.cross(n);
    const double length = std::sqrt(right.dot(right));
    orthonormal_basis(n, u, v);  // for an `up` along the view direction: any will do
    if (length > 0) u = right / length;
    v = n.cross(u);
    const double half_angle = c.fov_degrees / 2 * (std::numbers::pi / 180);
    const double plane_height = 2 * distance * std::tan(half_angle);
    pixel_size = Vec2(plane_height / (c.stretched ? width : height), plane_height / height);
    lens_radius = c.aperture * pixel_size.y / 2;
}

void CameraRays::rays(std::span<const Vec2> pixels, std::span<const Vec2> lens,
                      std::span<Ray> rays) const {
    RayChunk chunk;
    for (std::size_t first = 0; first < rays.size(); first += RayChunk::most) {
        chunk.count = std::min(RayChunk::most, rays.size() - first);
        for (std::size_t i = 0; i < chunk.count; ++i) {
            chunk.pixels[i] = pixels[first + i];
            if (has_lens())
                chunk.on_lens[i] = concentric_disk(lens[first + i]) * frame_.lens_radius;
        }
        HWY_DYNAMIC_DISPATCH(make_rays)(frame_, chunk);
        for (std::size_t i = 0; i < chunk.count; ++i) {
            rays[first + i] = {chunk.origins[i], chunk.directions[i]};
        }
    }
}

Ray CameraRays::ray(const Vec2& pixel, const Vec2& lens) const {
    Ray ray;
    rays({&pixel, 1}, {&lens, 1}, {&ray, 1});
    return ray;
}

Imath::M44d CameraRays::world_to_camera() const {
    return {frame_.u.x,
            frame_.v.x,
            frame_.n.x,
            0,  //
            frame_.u.y,
            frame_.v.y,
            frame_.n.y,
            0,  //
            frame_.u.z,
            frame_.v.z,
            frame_.n.z,
            0,  //
            -frame_.eye.dot(frame_.u),
            -frame_.eye.dot(frame_.v),
            -frame_.eye.dot(frame_.n),
            1};
}

Imath::M44d CameraRays::world_to_ndc() const {
    const double half_width = frame_.width / 2 * frame_.pixel_size.x;
    const double half_height = frame_.height / 2 * frame_.pixel_size.y;
    const Imath::M44d project(frame_.distance / half_width, 0, 0, 0,   //
                              0, frame_.distance / half_height, 0, 0,  //
                              0, 0, -1, -1,                            //
                              0, 0, 0, 0);
    return world_to_camera() * project;
}

}  // namespace etalon
#endif
