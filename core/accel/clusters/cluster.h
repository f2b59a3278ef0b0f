// Primitives of one kind side by side, in floats of normalized space, so that one set of vector
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

/// Primitive numbers; lanes that are not taken repeat the last one's.
using Ids = std::array<std::uint32_t, cluster_lanes>;

/// Triangles of one cluster. Lanes that are not taken hold NaN, which no ray meets. What the filter
/// reads comes first; of a lane that passes, all else that the kernel must know before it reads the
/// corners is in one cache line.
struct alignas(64) TriangleCluster {
    /// Sets nothing, so that many are first written by the threads that fill them.
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

/// Spheres of one cluster. All a kernel needs of one is in two cache lines, read together.
struct alignas(64) SphereCluster {
    SphereCluster() {}
    void fill(const Geometry& geometry, const NormalizedSpace& space,
              std::span<const std::uint32_t> all);

    std::array<Lanes, 3> centre;
    Lanes radius;  ///< radii with room for every rounding, see SphereFilter
    Ids ids;
    std::array<Sides, cluster_lanes> sides;
    alignas(32) std::array<Sphere, cluster_lanes> exact;
};

static_assert(sizeof(TriangleCluster) == 448 && sizeof(SphereCluster) == 448);

}  // namespace etalon
