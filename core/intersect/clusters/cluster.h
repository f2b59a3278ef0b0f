// Primitives of one kind side by side, placed in a frame, so that one set of vector instructions
// rejects those that a ray cannot hit. See filter-inl.h for the tests.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/intersect/frame.h"
#include "core/scene/scene.h"

namespace etalon {

/// As many primitives as a cluster has room for: the floats of an AVX register, two of SSE or NEON.
inline constexpr std::size_t cluster_lanes = 8;

using Lanes = std::array<float, cluster_lanes>;

/// Primitive numbers.
using Ids = std::array<std::uint32_t, cluster_lanes>;

/// Coordinates as multiples of a step.
using Steps = std::array<std::uint16_t, cluster_lanes>;

/// Corners are on a grid of the cluster's own, of 2^16 steps along each axis: half the space of
/// floats, and finer than the roundings of a ray unless the cluster takes a twentieth of the frame.
/// What the filter reads comes first; of a lane that passes, all else that the kernel must know
/// before it reads the corners is in one cache line.
struct alignas(64) TriangleCluster {
    /// Sets nothing, so that many are first written by the threads that fill them.
    TriangleCluster() {}

    /// With at least one of them. Lanes that are not taken repeat the last.
    void fill(const Scene& scene, const Frame& frame, std::span<const std::uint32_t> all);

    Vec3f base;            ///< where the grid begins, in the frame
    float steps_per_unit;  ///< a power of two
    float doubt;           ///< bound on the error of an edge function, in steps: edge_doubt()
    std::uint32_t taken;   ///< lanes that hold a triangle
    std::array<Sides, cluster_lanes> sides;
    Ids ids;
    std::array<std::array<Steps, 3>, 3> corners;  ///< of each corner x, y and z
    std::array<std::array<std::uint32_t, 3>, cluster_lanes> vertices;

  private:
    void set_corners(const std::array<std::array<Vec3, 3>, cluster_lanes>& places);
};

/// What a kernel needs of a sphere is in two cache lines that can be read together. Radii of lanes
/// that are not taken are NaN, which no ray meets.
struct alignas(64) SphereCluster {
    SphereCluster() {}
    void fill(const Scene& scene, const Frame& frame, std::span<const std::uint32_t> all);

    std::array<Lanes, 3> centre;
    Lanes radius;  ///< with room for every rounding, see SphereFilter
    Ids ids;
    std::array<Sides, cluster_lanes> sides;
    alignas(32) std::array<Sphere, cluster_lanes> exact;
};

static_assert(sizeof(TriangleCluster) == 320 && sizeof(SphereCluster) == 448);

}  // namespace etalon
