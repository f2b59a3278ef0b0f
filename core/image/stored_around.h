#pragma once

#include <array>
#include <cstdint>

#include "core/image/bilinear.h"
#include "core/image/subsampled_image.h"

namespace etalon {

/// What a subsampled image stores around each of many points, in columns for vectors.
struct StoredAround {
    static constexpr std::size_t most = BilinearPoints::most;
    using Column = std::array<std::int32_t, most>;

    /// Words of the luma of two pixels, in their lower two bytes, of the row of y and of the
    /// next.
    alignas(64) std::array<Column, 2> luma;
    /// Words of chroma of the column before that of x + 1, and of the next two, in their lower
    /// three bytes; of the row before that of y + 1, of the next, and of the one that the pixels
    /// of y + 1 are interpolated with.
    alignas(64) std::array<Column, 3> cb, cr;
};

/// Reads what is stored around `points`. The values from their count on are left as they are.
void read_around(const BilinearPoints& points, const SubsampledImage& image, StoredAround& stored);

}  // namespace etalon
