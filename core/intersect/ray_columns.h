#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/intersect/ray_stream.h"

namespace etalon {

/// Some rays with their components apart, and what can be said of several at a time.
struct RayColumns {
    /// So many that they stay in the fastest cache.
    static constexpr std::size_t most = 64;

    template <class T>
    using Column = std::array<T, most>;

    /// Sets the columns to up to `most` rays.
    explicit RayColumns(std::span<const Ray> rays);

    /// The same; the columns of the stream are not copied.
    explicit RayColumns(const RayStream& rays);

    RayColumns(const RayColumns&) = delete;
    RayColumns& operator=(const RayColumns&) = delete;

    std::size_t count = 0;
    Vec3Span origins, directions;  ///< padded
    Column<double> tmins, tmaxs;

    /// Other than 0 for what nearly all rays are: valid, and of directions whose components are
    /// zeros or within 2^-500 of the largest, which is of usual size (see RescaledRay).
    Column<std::uint64_t> common;
    Column<std::uint64_t> dominants;  ///< dominant axes of the directions
    bool are_alike =
        false;  ///< all are common rays of one dominant axis, as nearly all neighbours are

  private:
    Vec3Columns<most> own_origins_, own_directions_;
};

}  // namespace etalon
