#pragma once

#include <libdeflate.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace etalon {

/// Number of rows that OpenEXR's ZIP compresses together.
inline constexpr int exr_zip_rows = 16;

/// Compresses blocks as OpenEXR's ZIP does: even bytes before odd ones, each byte replaced by the
/// difference from the one before, in zlib's format. Keeps its memory from block to block.
class ExrZip {
  public:
    /// Throws std::bad_alloc if there is no memory for the compressor.
    ExrZip();

    /// Returns the compressed block, or the block itself if compression makes it no smaller; a file
    /// stores it the same way. The result is valid until the next call.
    std::span<const std::uint8_t> operator()(std::span<const std::uint8_t> block);

  private:
    struct FreeCompressor {
        void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
    };

    std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor_;
    std::vector<std::uint8_t> differences_, compressed_;
};

}  // namespace etalon
