// Primitives of one kind side by side, in floats of a frame, so that one set of vector instructions
// rejects those that a ray cannot hit. See filter-inl.h for the tests.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/intersect/normalized_space.h"
#include "core/scene/geometry.h"

namespace etalon {

/// As many primitives as a cluster has room for: the floats of an AVX register, two of SSE or NEON.
inline constexpr std::size_t cluster_lanes = 8;

using Lanes = std::array<float, cluster_lanes>;

/// Primitive numbers; lanes that are not taken repeat the last one's.
using Ids = std::array<std::uint32_t, cluster_lanes>;

/// Lanes that are not taken hold NaN, which no ray meets. What the filter reads comes first; of a
/// lane that passes, all else that the kernel must know before it reads the corners is in one cache
/// line.
struct alignas(64) TriangleCluster {
    /// Sets nothing, so that many are first written by the threads that fill them.
    TriangleCluster() {}

    /// With at least one of them.
    void fill(const Geometry& geometry, const NormalizedSpace& space,
              std::span<const std::uint32_t> all);

    std::array<std::array<Lanes, 3>, 3> corners;  ///< of each corner x, y and z
    float error_bound;  ///< bound on the error of an edge function, see TriangleFilter
    std::array<Sides, cluster_lanes> sides;
    alignas(32) Ids ids;
    std::array<std::array<std::uint32_t, 3>, cluster_lanes> vertices;
};

/// What a kernel needs of a sphere is in two cache lines that can be read together.
struct alignas(64) SphereCluster {
    SphereCluster() {}
    void fill(const Geometry& geometry, const NormalizedSpace& space,
              std::span<const std::uint32_t> all);

    std::array<Lanes, 3> centre;
    Lanes radius;  ///< with room for every rounding, see SphereFilter
    Ids ids;
    std::array<Sides, cluster_lanes> sides;
    alignas(32) std::array<Sphere, cluster_lanes> exact;
};

static_assert(sizeof(TriangleCluster) == 448 && sizeof(SphereCluster) == 448);

}  // namespace etalon
