#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/intersect/ray.h"
#include "core/numerics/vec_columns.h"

namespace etalon {

/// Some rays side by side, and what can be said of several at a time.
struct RayColumns {
    /// So many that they stay in the fastest cache.
    static constexpr std::size_t most = 64;

    /// Sets the columns to up to `most` rays.
    explicit RayColumns(std::span<const Ray> rays);

    std::size_t count = 0;
    Vec3Columns<most> origins, directions;
    std::array<double, most> tmins, tmaxs;

    /// Other than 0 for what nearly all rays are: valid, and of directions whose components are
    /// zeros or within 2^-500 of the largest, which is of usual size (see RescaledRay).
    std::array<std::uint64_t, most> common;
    std::array<std::uint64_t, most> dominants;  ///< dominant axes of the directions
};

}  // namespace etalon
