// PNG files, by libpng.
#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/image/extent.h"
#include "core/image/image.h"

namespace etalon {

/// A PNG file as sRGB, whatever it says of gamma and profile: grey or RGB, with alpha where it has
/// any, by which nothing is multiplied. A palette's colours, and values of fewer than 8 bits spread
/// over all of them, are bytes; 16 bits are floats in [0, 1]. A failure's reason does not name the
/// file. May throw std::bad_alloc.
Result<Image> read_png(std::FILE* file, Extent extent);

/// What a PNG says beside its pixels.
struct PngFacts {
    std::optional<Imath::V2i> origin{};                        ///< of a crop in its frame
    std::vector<std::pair<std::string, std::string>> texts{};  ///< keywords, and texts in UTF-8
};

/// A PNG file in memory, marked as sRGB, of width * height pixels R, G, B by rows from the top.
Result<std::string> encode_png(std::span<const std::uint8_t> rgb, int width, int height,
                               const PngFacts& facts = {});

}  // namespace etalon
