#pragma once

#include <cstdint>
#include <vector>

namespace etalon {

/// Number of rows that OpenEXR's ZIP compresses together.
inline constexpr int exr_zip_rows = 16;

/// Compresses a block as OpenEXR's ZIP does: even bytes before odd ones, each byte replaced by the
/// difference from the one before, in zlib's format. Returns the block itself if compression makes
/// it no smaller; a file stores it the same way.
std::vector<std::uint8_t> zip_exr_block(std::vector<std::uint8_t> block);

}  // namespace etalon
