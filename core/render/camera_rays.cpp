#include "core/render/camera_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#define ETALON_WITH_AVX3
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
                    to_eye = broadcast(c.to_eye);
    const Doubles axis_x = broadcast(c.axis.x), axis_y = broadcast(c.axis.y),
                  width = broadcast(c.pixel_size.x), height = broadcast(c.pixel_size.y),
                  focal = broadcast(c.focal);
    const bool is_parallel = c.projection == Projection::orthographic, has_lens = c.lens_radius > 0;
    for (std::size_t i = 0; i < rays.count; i += hn::Lanes(tag)) {
        const Vec2Lanes pixel = load(&rays.pixels[i]);
        const Doubles x = (pixel.x - axis_x) * width, y = (axis_y - pixel.y) * height;
        const Vec3Lanes place = x * u + y * v;
        Vec3Lanes origin = eye, direction = place - to_eye;
        if (has_lens) {
            const Vec2Lanes disk = load(&rays.on_lens[i]);
            const Vec3Lanes offset = disk.x * u + disk.y * v;
            origin = eye + offset;
            direction = is_parallel ? place - focal * to_eye - offset : focal * direction - offset;
        } else if (is_parallel) {
            origin = eye + place;
            direction = broadcast(-c.to_eye);
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

/// Sets rays to all directions: rows are angles from the camera's y axis, columns those about it,
/// from x by z.
void make_environment_rays(const CameraFrame& c, RayChunk& rays) {
    for (std::size_t i = 0; i < rays.count; ++i) {
        const Vec2 part = rays.pixels[i] * c.pixel_size;
        const double theta = std::numbers::pi * part.y, phi = 2 * std::numbers::pi * part.x;
        const double sine = std::sin(theta);
        rays.origins[i] = c.eye;
        rays.directions[i] = normalized(sine * std::cos(phi) * c.u + std::cos(theta) * c.v -
                                        sine * std::sin(phi) * c.to_eye);
    }
}

/// Makes rays of a camera that stands where `frame` says.
void make_all(const CameraFrame& frame, std::span<const Vec2> pixels, std::span<const Vec2> lens,
              std::span<Ray> rays) {
    RayChunk chunk;
    for (std::size_t first = 0; first < rays.size(); first += RayChunk::most) {
        chunk.count = std::min(RayChunk::most, rays.size() - first);
        for (std::size_t i = 0; i < chunk.count; ++i) {
            chunk.pixels[i] = pixels[first + i];
            if (frame.lens_radius > 0)
                chunk.on_lens[i] = concentric_disk(lens[first + i]) * frame.lens_radius;
        }
        if (frame.projection == Projection::environment) {
            make_environment_rays(frame, chunk);
        } else {
            HWY_DYNAMIC_DISPATCH(make_rays)(frame, chunk);
        }
        for (std::size_t i = 0; i < chunk.count; ++i) {
            rays[first + i] = {chunk.origins[i], chunk.directions[i]};
        }
    }
}

}  // namespace

CameraRays::CameraRays(const Camera& camera, const Imath::V2i& resolution)
    : frame_(camera_frame(camera, resolution)) {
    const auto& projective = camera.projective;
    if (!projective) return;
    motion_ = projective->motion;
    if (projective->projection == Projection::lens_system) {
        lens_ = std::make_shared<const LensRays>(*projective->lens, resolution);
    }
}

CameraFrame CameraRays::frame_at(ShutterTime time) const {
    CameraFrame frame = frame_;
    if (motion_ && time != 0) frame.move_rays(motion_->at(time));
    return frame;
}

void CameraRays::rays(std::span<const Vec2> pixels, std::span<const Vec2> lens,
                      std::span<Ray> rays) const {
    if (lens_) {
        std::vector<float> weights(rays.size());
        return weighted_rays(pixels, lens, {}, rays, weights);
    }
    make_all(frame_, pixels, lens, rays);
}

void CameraRays::weighted_rays(std::span<const Vec2> pixels, std::span<const Vec2> lens,
                               std::span<const ShutterTime> times, std::span<Ray> rays,
                               std::span<float> weights) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const ShutterTime time = times.empty() ? ShutterTime(0) : times[i];
        const CameraFrame c = frame_at(time);
        const auto vector = [&](const Vec3& d) { return d.x * c.u + d.y * c.v - d.z * c.to_eye; };
        const auto [ray, weight] = lens_->ray(pixels[i], lens[i]);
        rays[i] = {c.eye + vector(ray.origin), normalized(vector(ray.direction))};
        rays[i].set_time(time);
        weights[i] = weight;
    }
}

Ray CameraRays::ray(const Vec2& pixel, const Vec2& lens, ShutterTime time) const {
    Ray ray;
    float weight = 1;
    if (lens_) {
        weighted_rays({&pixel, 1}, {&lens, 1}, {&time, 1}, {&ray, 1}, {&weight, 1});
    } else {
        make_all(frame_at(time), {&pixel, 1}, {&lens, 1}, {&ray, 1});
        ray.set_time(time);
    }
    return ray;
}

}  // namespace etalon
#endif
