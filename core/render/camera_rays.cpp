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

/// A chunk of rays that are being generated: so few that they stay in the first-level cache.
struct RayChunk {
    static constexpr std::size_t most = 64;

    std::size_t count;
    std::array<Vec2, most> pixels, on_lens;  ///< the latter on a disk of the lens' radius
    MutableVec3Span origins, directions;     ///< outputs; padded
};

}  // namespace etalon
#endif

HWY_BEFORE_NAMESPACE();
namespace etalon::HWY_NAMESPACE {

void make_rays(const CameraFrame& c, const RayChunk& rays) {
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
        store(origin, rays.origins, i);
        store(normalized(direction), rays.directions, i);
    }
}

}  // namespace etalon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace etalon {

HWY_EXPORT(make_rays);

namespace {

/// Maps the unit square to the unit disk, preserving areas (Shirley & Chiu 1997, "A Low Distortion
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

/// Generates rays in all directions: rows are angles from the camera's y axis, columns angles about
/// it, from x towards z.
void make_environment_rays(const CameraFrame& c, const RayChunk& rays) {
    for (std::size_t i = 0; i < rays.count; ++i) {
        const Vec2 part = rays.pixels[i] * c.pixel_size;
        const double theta = std::numbers::pi * part.y, phi = 2 * std::numbers::pi * part.x;
        const double sine = std::sin(theta);
        rays.origins.set(i, c.eye);
        rays.directions.set(i, normalized(sine * std::cos(phi) * c.u + std::cos(theta) * c.v -
                                          sine * std::sin(phi) * c.to_eye));
    }
}

/// Generates rays of a camera with the given frame; `to_origins` and `to_directions` are padded.
void make_all(const CameraFrame& frame, std::span<const Vec2> pixels, std::span<const Vec2> lens,
              const MutableVec3Span& to_origins, const MutableVec3Span& to_directions) {
    RayChunk chunk;
    for (std::size_t first = 0; first < pixels.size(); first += RayChunk::most) {
        chunk.count = std::min(RayChunk::most, pixels.size() - first);
        chunk.origins = to_origins.from(first);
        chunk.directions = to_directions.from(first);
        std::copy_n(&pixels[first], chunk.count, chunk.pixels.begin());
        if (frame.lens_radius > 0) {
            std::transform(&lens[first], &lens[first] + chunk.count, chunk.on_lens.begin(),
                           [&](const Vec2& p) { return concentric_disk(p) * frame.lens_radius; });
        }
        if (frame.projection == Projection::environment) {
            make_environment_rays(frame, chunk);
        } else {
            HWY_DYNAMIC_DISPATCH(make_rays)(frame, chunk);
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

CameraRays::WeightedRay CameraRays::weighted_ray(const Vec2& pixel, const Vec2& lens,
                                                 ShutterTime time) const {
    const CameraFrame c = frame_at(time);
    const auto vector = [&](const Vec3& d) { return d.x * c.u + d.y * c.v - d.z * c.to_eye; };
    const auto [ray, weight] = lens_->ray(pixel, lens);
    return {c.eye + vector(ray.origin), normalized(vector(ray.direction)), weight};
}

void CameraRays::rays(std::span<const Vec2> pixels, std::span<const Vec2> lens,
                      RayBuffer& rays) const {
    if (lens_) {
        std::vector<float> weights(pixels.size());
        return weighted_rays(pixels, lens, {}, rays, weights);
    }
    make_all(frame_, pixels, lens, rays.origins.span(), rays.directions.span());
    std::fill_n(rays.excludes.data(), pixels.size(), no_index);
}

void CameraRays::weighted_rays(std::span<const Vec2> pixels, std::span<const Vec2> lens,
                               std::span<const ShutterTime> times, RayBuffer& rays,
                               std::span<float> weights) const {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const auto [origin, direction, weight] =
            weighted_ray(pixels[i], lens[i], times.empty() ? ShutterTime(0) : times[i]);
        rays.origins.set(i, origin);
        rays.directions.set(i, direction);
        weights[i] = weight;
    }
    std::fill_n(rays.excludes.data(), pixels.size(), no_index);
}

Ray CameraRays::ray(const Vec2& pixel, const Vec2& lens, ShutterTime time) const {
    Ray ray;
    if (lens_) {
        const auto [origin, direction, weight] = weighted_ray(pixel, lens, time);
        ray = {origin, direction};
    } else {
        Vec3Columns<padded_doubles> origin, direction;
        make_all(frame_at(time), {&pixel, 1}, {&lens, 1}, origin.span(), direction.span());
        ray = {origin[0], direction[0]};
    }
    ray.set_time(time);
    return ray;
}

}  // namespace etalon
#endif
