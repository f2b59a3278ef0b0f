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

/// Reads a PNG file as sRGB, ignoring its gamma and profile: grey or RGB, with alpha if it has any,
/// which is not multiplied in. Palettes, and values of fewer than 8 bits stretched to the full
/// range, become bytes; 16 bits become floats in [0, 1]. A failure's reason does not name the file.
/// May throw std::bad_alloc.
Result<Image> read_png(std::FILE* file, Extent extent);

/// Data of a PNG beside its pixels.
struct PngFacts {
    std::optional<Imath::V2i> origin{};                        ///< of a crop in its frame
    std::vector<std::pair<std::string, std::string>> texts{};  ///< keywords, with texts in UTF-8
};

/// Returns a PNG file in memory, marked as sRGB, from width * height pixels R, G, B in rows from
/// the top.
Result<std::string> encode_png(std::span<const std::uint8_t> rgb, int width, int height,
                               const PngFacts& facts = {});

}  // namespace etalon
