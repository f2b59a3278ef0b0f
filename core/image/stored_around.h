#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
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

/// Reads an image around points. Is inline, since compilers see then that what is stored does not
/// change the image.
class AroundPoints {
  public:
    AroundPoints(const SubsampledImage& image, const BilinearPoints& points, StoredAround& stored)
        : image_(image), points_(points), stored_(stored) {}

    void read(std::size_t i) const {
        const int x = points_.x[i], y = points_.y[i];
        stored_.luma[0][i] = luma(x, y);
        stored_.luma[1][i] = luma(x, std::min(y + 1, image_.height - 1));
        const int column = (x - 1) >> 1, row = (y - 1) >> 1;
        const std::array<int, 3> rows = {row, row + 1, y % 2 == 0 ? row + 2 : row};
        for (int k = 0; k < 3; ++k) {
            const int of_image = std::clamp(rows[k], 0, image_.chroma_height() - 1);
            stored_.cb[k][i] = three(image_.cb(of_image), column);
            stored_.cr[k][i] = three(image_.cr(of_image), column);
        }
    }

  private:
    std::int32_t luma(int x, int y) const {
        const std::uint8_t* const row = image_.luma(y);
        return row[x] | row[std::min(x + 1, image_.width - 1)] << 8;
    }

    /// Returns the bytes of three columns, and of another where that is one word to read.
    std::int32_t three(const std::uint8_t* row, int column) const {
        const int last = image_.chroma_width() - 1;
        const auto word = [](int a, int b, int c, unsigned d) {
            return static_cast<std::int32_t>(a | b << 8 | c << 16 | d << 24);
        };
        if (column >= 0 && column + 3 <= last) {
            const std::uint8_t* const p = row + column;
            return word(p[0], p[1], p[2], p[3]);
        }
        const auto byte = [&](int k) { return row[std::clamp(column + k, 0, last)]; };
        return word(byte(0), byte(1), byte(2), 0);
    }

    const SubsampledImage& image_;
    const BilinearPoints& points_;
    StoredAround& stored_;
};

}  // namespace etalon
