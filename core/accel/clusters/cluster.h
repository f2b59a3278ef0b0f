// Primitives of one kind in SoA layout, as floats in normalized space, so that one set of SIMD
// instructions rejects those that a ray cannot hit. See filter-inl.h for the tests.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/intersect/normalized_space.h"
#include "core/scene/geometry.h"

namespace etalon {

/// Number of primitives in a cluster: the floats of one AVX register, or of two of SSE or NEON.
inline constexpr std::size_t cluster_lanes = 8;

using Lanes = std::array<float, cluster_lanes>;

/// Primitive numbers; unused lanes repeat the last one.
using Ids = std::array<std::uint32_t, cluster_lanes>;

/// Triangles of one cluster. Unused lanes hold NaN, which no ray hits. The data that the filter
/// reads comes first. For a lane that passes, all that the kernel needs before it reads the corners
/// is in one cache line.
struct alignas(64) TriangleCluster {
    /// Leaves the members uninitialized, so that large arrays are first touched by the threads that
    /// fill them.
    TriangleCluster() {}

    /// Fills the lanes with the primitives `all`, at least one and at most cluster_lanes.
    void fill(const Geometry& geometry, const NormalizedSpace& space,
              std::span<const std::uint32_t> all);

    std::array<std::array<Lanes, 3>, 3> corners;  ///< x, y and z of each corner
    float error_bound;  ///< bound on the error of an edge function, see TriangleFilter
    std::array<Sides, cluster_lanes> sides;
    alignas(32) Ids ids;
    std::array<std::array<std::uint32_t, 3>, cluster_lanes> vertices;
};

/// Spheres of one cluster. All data of a sphere that a kernel needs is in two adjacent cache lines.
struct alignas(64) SphereCluster {
    SphereCluster() {}
    void fill(const Geometry& geometry, const NormalizedSpace& space,
              std::span<const std::uint32_t> all);

    std::array<Lanes, 3> centre;
    Lanes radius;  ///< enlarged radii, with room for all roundings: see SphereFilter
    Ids ids;
    std::array<Sides, cluster_lanes> sides;
    alignas(32) std::array<Sphere, cluster_lanes> exact;
};

static_assert(sizeof(TriangleCluster) == 448 && sizeof(SphereCluster) == 448);

}  // namespace etalon
