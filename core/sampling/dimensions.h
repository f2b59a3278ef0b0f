// The dimensions of a sample, named by their use. Every dimension is listed here, so that no two
// choices of a path share their numbers.
#pragma once

#include <cstdint>

#include "core/sampling/sobol.h"

namespace etalon {

/// Dimensions of a camera's choices, which are used as they are.
enum CameraDimension : std::uint32_t {
    pixel_dimension = 0,
    lens_dimension = 1,
    time_dimension = 2,  ///< only the first number is used
};

/// Choices at a vertex of a path. Each ray of a tree of rays has a name: a hash of the name of the
/// ray before it and the way it went. The dimension of a choice is a hash of the ray's name and the
/// choice. Choices that are made together use the name itself: see vertex_points.h.
enum PathDimension : std::uint32_t {
    same_side_ray = 0,               ///< name of the next ray, on the side of the incoming one
    other_side_ray = 1,              ///< name of the next ray, through the surface
    first_light = 2,                 ///< point on a light; light i has first_light + i
    occlusion_direction = 1U << 31,  ///< above all lights
    medium_collisions,               ///< of a ray in a medium, after the first
    shadow_collisions,               ///< of the shadow rays of a vertex
    along_ray_collisions,            ///< of a shadow ray from a point along a ray
    exit_vertex,                     ///< name of the vertex where subsurface light entered
    passing_ray,                     ///< name of the part of a ray that passes a medium
};

/// Name of a camera ray.
inline constexpr std::uint32_t camera_ray_name = 1;

inline std::uint32_t ray_name(std::uint32_t parent, bool crosses) {
    return hash(parent, crosses ? other_side_ray : same_side_ray);
}

inline std::uint32_t light_choice(std::size_t light) {
    return first_light + static_cast<std::uint32_t>(light);
}

inline std::uint32_t light_dimension(std::uint32_t ray, std::size_t light) {
    return hash(ray, light_choice(light));
}

inline std::uint32_t occlusion_dimension(std::uint32_t ray) {
    return hash(ray, occlusion_direction);
}

inline std::uint32_t collision_dimension(std::uint32_t ray) {
    return hash(ray, medium_collisions);
}

/// Returns the dimension of shadow ray number `k` of the vertex.
inline std::uint32_t shadow_collision_dimension(std::uint32_t ray, std::size_t k) {
    return hash(hash(ray, shadow_collisions), static_cast<std::uint32_t>(k));
}

inline std::uint32_t along_ray_collision_dimension(std::uint32_t ray) {
    return hash(ray, along_ray_collisions);
}

/// Returns the name of the vertex at which light enters that is scattered below the surface of
/// vertex `ray`.
inline std::uint32_t exit_name(std::uint32_t ray) {
    return hash(ray, exit_vertex);
}

/// Returns the name of the part of ray `ray` that passes the medium, the rest being scattered.
inline std::uint32_t passing_name(std::uint32_t ray) {
    return hash(ray, passing_ray);
}

/// Dimensions of a ray set's choices, for samples of its own.
enum RaySetDimension : std::uint32_t { bounce_dimension = 0, shadow_dimension = 1 };

}  // namespace etalon
