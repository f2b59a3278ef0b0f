// Primitives of one kind side by side, in floats of a frame, so that one set of vector instructions
// rejects those that a ray cannot hit. See filter-inl.h for the tests.
#pragma once

#include <array>
#include <cstdint>

#include "core/intersect/frame.h"
#include "core/scene/scene.h"

namespace etalon {

/// As many primitives as a cluster has room for: the floats of an AVX register, two of SSE or NEON.
inline constexpr std::size_t cluster_lanes = 8;

using Lanes = std::array<float, cluster_lanes>;

/// Five cache lines. Lanes that are not taken hold NaN, which no ray meets.
struct alignas(64) TriangleCluster {
    TriangleCluster();
    void set(std::size_t lane, const Scene& scene, const Frame& frame, std::uint32_t id);

    std::array<std::array<Lanes, 3>, 3> corners;  ///< of each corner x, y and z
    Lanes doubt;  ///< bound on the error of an edge function, see TriangleFilter
};

/// Two cache lines. Lanes that are not taken hold NaN.
struct alignas(64) SphereCluster {
    SphereCluster();
    void set(std::size_t lane, const Scene& scene, const Frame& frame, std::uint32_t id);

    std::array<Lanes, 3> centre;
    Lanes radius;  ///< with room for every rounding, see SphereFilter
};

static_assert(sizeof(TriangleCluster) == 320 && sizeof(SphereCluster) == 128);

}  // namespace etalon
