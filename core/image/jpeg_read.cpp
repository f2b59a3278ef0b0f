#include "core/image/jpeg_read.h"

#include <sys/stat.h>

#include <cstdio>  // jpeglib.h needs it

#include <jerror.h>
#include <jpeglib.h>

#include "core/image/lack_of_memory.h"
#include "core/image/library_jump.h"
#include "core/image/read_by_rows.h"

namespace etalon {
namespace {

LibraryJump& jump_of(j_common_ptr info) {
    return *static_cast<LibraryJump*>(info->client_data);
}

/// Returns a message for an error of libjpeg, whose own messages describe its internal state.
const char* reason_of(int error) {
    switch (error) {
        case JERR_OUT_OF_MEMORY:
            return lack_of_memory;
        case JERR_IMAGE_TOO_BIG:
            return "larger than 65500 pixels";
        case JERR_BAD_PRECISION:
        case JERR_SOF_UNSUPPORTED:
        case JERR_ARITH_NOTIMPL:
        case JERR_CONVERSION_NOTIMPL:
        case JERR_FRACT_SAMPLE_NOTIMPL:
        case JERR_NOTIMPL:
            return "JPEGs of this kind are not supported";
        default:
            return "the JPEG is damaged or cut short";
    }
}

void fail(j_common_ptr info) {
    LibraryJump& jump = jump_of(info);
    std::snprintf(jump.reason, LibraryJump::capacity, "%s", reason_of(info->err->msg_code));
    jump.leave();
}

/// Returns whether a scan ended while whole rows of its blocks are missing. After a restart marker
/// the scan continues.
bool lacks_rows(const jpeg_decompress_struct& info) {
    const int marker = info.unread_marker;
    const bool restarts = marker >= JPEG_RST0 && marker < JPEG_RST0 + 8;
    return !restarts && info.input_iMCU_row + 1 < info.total_iMCU_rows;
}

/// Returns whether a scan refines blocks that no scan began, or begins them again. No program
/// writes such files, of which a few bytes can stand for all blocks of a large image.
bool begins_late(const jpeg_error_mgr& warning) {
    return warning.msg_code == JWRN_BOGUS_PROGRESSION && warning.msg_parm.i[1] == 0;
}

/// Fails if a file or a scan ends early, which libjpeg would show as grey, or begins late. Other
/// warnings are ignored.
void note(j_common_ptr info, int level) {
    if (level >= 0) return;
    const int warning = info->err->msg_code;
    const auto& decoder = *reinterpret_cast<j_decompress_ptr>(info);
    const bool ends_early = warning == JWRN_HIT_MARKER && lacks_rows(decoder);
    if (warning == JWRN_JPEG_EOF || ends_early || begins_late(*info->err)) fail(info);
}

/// Fails after more scans than any program writes, each of which takes the time of all blocks.
void count_scans(j_common_ptr info) {
    constexpr int most_scans = 100;
    if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number > most_scans) fail(info);
}

/// Reads the rest of a file. The file's size is only a hint, since the file may change.
PixelBytes rest_of(std::FILE* file) {
    constexpr std::size_t most = 1 << 16;  // bytes at a time
    PixelBytes bytes;
    struct stat facts = {};
    if (::fstat(::fileno(file), &facts) == 0 && facts.st_size > 0)
        bytes.reserve(facts.st_size + most);
    for (std::size_t read = most; read == most;) {
        const std::size_t done = bytes.size();
        bytes.resize(done + most);
        read = std::fread(&bytes[done], 1, most, file);
        bytes.resize(done + read);
    }
    return bytes;
}

/// Converts CMYK, inverted as Adobe's programs store it (255 is no ink), to RGB. Each channel is
/// multiplied by black, as in OpenImageIO.
void to_rgb(const std::uint8_t* inks, std::uint8_t* rgb, int count) {
    const auto part = [](std::uint8_t byte) { return static_cast<float>(byte) * (1.0F / 255); };
    for (; count > 0; --count, inks += 4, rgb += 3) {
        for (int k = 0; k < 3; ++k) {
            rgb[k] = static_cast<std::uint8_t>(part(inks[k]) * part(inks[3]) * 255.0F + 0.5F);
        }
    }
}

/// Decoder of one file. Its functions return false on failure, for which reason() gives the cause.
class JpegReader {
  public:
    /// Reads a header from the file itself. A whole image is decoded from memory, since libjpeg is
    /// slow near the end of its source's buffer, and its buffer of a file has only 4 KB.
    JpegReader(std::FILE* file, Extent extent) {
        // Comes first: if it throws, nothing of libjpeg is left to be destroyed.
        if (extent == Extent::whole) bytes_ = rest_of(file);
        info_.err = jpeg_std_error(&errors_);
        info_.client_data = &jump_;
        errors_.error_exit = fail;
        errors_.emit_message = note;
        progress_.progress_monitor = count_scans;
        opened_ = jump_.completes([&] {
            jpeg_create_decompress(&info_);
            info_.progress = &progress_;
            if (extent == Extent::header)
                jpeg_stdio_src(&info_, file);
            else
                jpeg_mem_src(&info_, bytes_.data(), bytes_.size());
        });
    }
    ~JpegReader() { jpeg_destroy_decompress(&info_); }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;

    bool read_header() {
        return opened_ && jump_.completes([&] { jpeg_read_header(&info_, TRUE); });
    }
    bool start() {
        if (has_inks()) {
            info_.out_color_space = JCS_CMYK;
            inks_.resize(static_cast<std::size_t>(width()) * 4);
        }
        return jump_.completes([&] { jpeg_start_decompress(&info_); });
    }
    bool read_rows(std::uint8_t* first, int count) {
        return jump_.completes([&] {
            const std::size_t row = static_cast<std::size_t>(width()) * channels();
            for (int i = 0; i < count; ++i) read_row(first + static_cast<std::size_t>(i) * row);
        });
    }

    int width() const { return static_cast<int>(info_.image_width); }
    int height() const { return static_cast<int>(info_.image_height); }
    int channels() const { return has_inks() ? 3 : info_.num_components; }
    std::string reason() const { return jump_.reason; }

  private:
    /// Returns whether the four channels are CMYK.
    bool has_inks() const {
        return info_.jpeg_color_space == JCS_CMYK || info_.jpeg_color_space == JCS_YCCK;
    }

    void read_row(std::uint8_t* to) {
        JSAMPROW target = has_inks() ? inks_.data() : to;
        jpeg_read_scanlines(&info_, &target, 1);
        if (has_inks()) to_rgb(inks_.data(), to, width());
    }

    LibraryJump jump_;
    jpeg_error_mgr errors_ = {};
    jpeg_progress_mgr progress_ = {};
    jpeg_decompress_struct info_ = {};
    PixelBytes bytes_;
    std::vector<std::uint8_t> inks_;  ///< CMYK values of a row
    bool opened_ = false;
};

/// Reads the pixels after the header. Returns the reason of a failure, or an empty string.
std::string read_pixels(JpegReader& reader, Image& image) {
    if (!reader.start()) return reader.reason();
    const auto read = [&](std::uint8_t* first, int count) {
        return reader.read_rows(first, count);
    };
    PixelBytes bytes;
    const std::size_t row = static_cast<std::size_t>(image.width) * image.channels;
    if (!read_by_rows(row, image.height, read, bytes)) return reader.reason();
    image.pixels = std::move(bytes);
    return {};
}

}  // namespace

Result<Image> read_jpeg(std::FILE* file, Extent extent) {
    constexpr int most_channels = 4;
    JpegReader reader(file, extent);
    if (!reader.read_header()) return {{}, reader.reason()};
    if (reader.channels() > most_channels) return {{}, reason_of(JERR_NOTIMPL)};
    Result<Image> image;
    image.value = {reader.width(), reader.height(), reader.channels(), {}, Encoding::srgb, {}};
    if (extent == Extent::whole) image.error = read_pixels(reader, image.value);
    if (!image) image.value = {};
    return image;
}

}  // namespace etalon
