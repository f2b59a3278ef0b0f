#pragma once

#include <Imath/ImathVec.h>
#include <OpenEXR/openexr.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>

namespace etalon {

/// A block of lines, or a tile of the largest level.
struct ExrChunk {
    exr_chunk_info_t info;  ///< its sizes in pixels and bytes
    Imath::V2i corner;      ///< its first pixel, counted from the corner of the data window
};

struct FreeBytes {
    void operator()(std::uint8_t* bytes) const { std::free(bytes); }
};
using ExrBytes = std::unique_ptr<std::uint8_t[], FreeBytes>;

/// The chunks of the first part of an OpenEXR file, which is not deep, with all their bytes. Uses
/// OpenEXR's C library: its C++ library, up to version 3.1, does not check how many bytes an
/// uncompressed, RLE or ZIP chunk has, and gives what was in its memory for those that are missing.
/// All functions throw std::bad_alloc, or std::runtime_error if the file is damaged.
class ExrChunks {
  public:
    /// Opens a file. OpenEXR's libraries decide in different ways whether it has tiles or lines, so
    /// the C++ library's answer is compared.
    ExrChunks(const std::string& path, bool is_tiled);

    /// Returns the size of the data window.
    const Imath::V2i& size() const { return size_; }

    /// Returns the file's channels, in the order of their values in a line of a chunk.
    std::span<const exr_attr_chlist_entry_t> channels() const;

    /// Calls visit(chunk) for all chunks, in the order of the image's rows.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (int y = 0; y < size_.y;) {
            int rows = 0;
            for (int x = 0; x < size_.x;) {
                const ExrChunk chunk = chunk_at({x, y});
                visit(chunk);
                x += chunk.info.width;
                rows = chunk.info.height;
            }
            y += rows;
        }
    }

    /// Returns whether decode() is for this file's compression: none, RLE or ZIP. The C library of
    /// version 3.1 lacks some of the others.
    bool can_decode() const;

    /// Returns a chunk's values, info.unpacked_size bytes: line by line, and in each line channel
    /// by channel.
    ExrBytes decode(const ExrChunk& chunk) const;

  private:
    struct Close {
        void operator()(_priv_exr_context_t* file) const { exr_finish(&file); }
    };

    /// Returns the chunk that begins at a pixel.
    ExrChunk chunk_at(const Imath::V2i& corner) const;

    std::unique_ptr<_priv_exr_context_t, Close> file_;
    Imath::V2i origin_, size_;       ///< of the data window
    Imath::V2i tile_size_ = {0, 0};  ///< 0 for lines
    exr_compression_t compression_;
};

}  // namespace etalon
