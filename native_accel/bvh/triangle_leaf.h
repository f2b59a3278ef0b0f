#pragma once

#include <array>

#include "core/intersect/frame.h"
#include "core/scene/scene.h"
#include "native_accel/bvh/float4.h"

namespace etalon {

/// Up to four triangles in the frame, rounded to float, for TriangleFilter to test at once.
struct alignas(16) TriangleLeaf {
    static constexpr std::uint32_t lanes = 4;

    /// No lane is taken: NaN for corners, which no ray meets.
    TriangleLeaf();

    void set(std::size_t lane, const Scene& scene, const Frame& frame, std::uint32_t id);

    std::array<std::array<Float4, 3>, 3> corners;  ///< of each corner x, y and z
    Float4 doubt;  ///< bound on the error of an edge function, see TriangleFilter
    std::array<std::uint32_t, lanes> ids;  ///< primitive numbers
};

}  // namespace etalon
