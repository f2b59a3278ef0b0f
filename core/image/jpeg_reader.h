// libjpeg behind functions that fail in the usual way.
#pragma once

#include <cstdint>
#include <cstdio>  // jpeglib.h needs it
#include <string>
#include <vector>

#include <jpeglib.h>

#include "core/image/extent.h"
#include "core/image/image.h"
#include "core/image/library_jump.h"
#include "core/image/subsampled_image.h"

namespace etalon {

/// Decoder of one JPEG file. Its functions return false on failure, for which reason() gives the
/// cause.
class JpegReader {
  public:
    /// Reads a header from the file itself. A whole image is decoded from memory, since libjpeg is
    /// slow near the end of its source's buffer, and its buffer of a file has only 4 KB.
    JpegReader(std::FILE* file, Extent extent);
    ~JpegReader() { jpeg_destroy_decompress(&info_); }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;

    bool read_header();

    /// Starts decoding to bytes of RGB or grey, which read_rows() then gives.
    bool start();
    bool read_rows(std::uint8_t* first, int count);

    /// Returns whether SubsampledImage stores the same colours.
    bool is_subsampled() const;

    /// Starts decoding to row pairs of SubsampledImage, which read_row_pairs() then gives, a
    /// multiple of eight at a time, as many as whole blocks have.
    bool start_unconverted();
    bool read_row_pairs(std::uint8_t* first, int count);

    int width() const { return static_cast<int>(info_.image_width); }
    int height() const { return static_cast<int>(info_.image_height); }
    int channels() const { return has_inks() ? 3 : info_.num_components; }
    std::string reason() const { return jump_.reason; }

    /// Returns the message for files of a kind that is not supported.
    static std::string unsupported();

  private:
    bool has_inks() const;
    void read_row(std::uint8_t* to);
    void read_block_row(std::uint8_t* to);

    LibraryJump jump_;
    jpeg_error_mgr errors_ = {};
    jpeg_progress_mgr progress_ = {};
    jpeg_decompress_struct info_ = {};
    PixelBytes bytes_;
    std::vector<std::uint8_t> inks_;  ///< CMYK values of a row
    bool opened_ = false;
};

}  // namespace etalon
