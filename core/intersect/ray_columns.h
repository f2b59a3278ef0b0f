#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "core/intersect/ray_stream.h"

namespace etalon {

/// Up to `most` rays as a structure of arrays, with properties computed several at a time.
struct RayColumns {
    /// Most rays; few enough to stay in the L1 cache.
    static constexpr std::size_t most = 64;

    template <class T>
    using Column = std::array<T, most>;

    /// Copies up to `most` rays to the columns.
    explicit RayColumns(std::span<const Ray> rays);

    /// The same; the columns of the stream are not copied.
    explicit RayColumns(const RayStream& rays);

    bool are_common() const {
        return std::ranges::all_of(std::span(common).first(count), [](auto c) { return c != 0; });
    }

    RayColumns(const RayColumns&) = delete;
    RayColumns& operator=(const RayColumns&) = delete;

    std::size_t count = 0;
    Vec3Span origins, directions;  ///< padded
    Column<double> tmins, tmaxs;

    /// Not 0 for common rays: those that are valid and have a direction whose components are 0 or
    /// at least 2^-500 times the largest, which has a usual size (see RescaledRay). Nearly all rays
    /// are.
    Column<std::uint64_t> common;
    Column<std::uint64_t> dominants;  ///< dominant axes of the directions
    bool are_alike =
        false;  ///< all are common rays of one dominant axis, as nearly all neighbours are

  private:
    Vec3Columns<most> own_origins_, own_directions_;
};

}  // namespace etalon
