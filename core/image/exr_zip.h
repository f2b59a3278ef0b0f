#pragma once

#include <cstdint>
#include <vector>

namespace etalon {

/// Rows that OpenEXR's ZIP compresses together.
inline constexpr int exr_zip_rows = 16;

/// Compresses a block as OpenEXR's ZIP does: even bytes before odd ones, of all the difference from
/// the byte before, by zlib's format. Returns the block itself if that makes it no smaller, which
/// is how a file says so too.
std::vector<std::uint8_t> zip_exr_block(std::vector<std::uint8_t> block);

}  // namespace etalon
