#include "core/image/jpeg_reader.h"

#include <sys/stat.h>

#include <array>

#include <jerror.h>

#include "core/image/lack_of_memory.h"

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

}  // namespace

JpegReader::JpegReader(std::FILE* file, Extent extent) {
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

bool JpegReader::read_header() {
    return opened_ && jump_.completes([&] { jpeg_read_header(&info_, TRUE); });
}

bool JpegReader::start() {
    if (has_inks()) {
        info_.out_color_space = JCS_CMYK;
        inks_.resize(static_cast<std::size_t>(width()) * 4);
    }
    return jump_.completes([&] { jpeg_start_decompress(&info_); });
}

bool JpegReader::read_rows(std::uint8_t* first, int count) {
    return jump_.completes([&] {
        const std::size_t row = static_cast<std::size_t>(width()) * channels();
        for (int i = 0; i < count; ++i) read_row(first + static_cast<std::size_t>(i) * row);
    });
}

/// Chroma of two columns or fewer is not interpolated by libjpeg.
bool JpegReader::is_subsampled() const {
    constexpr int narrowest = 5;
    if (info_.jpeg_color_space != JCS_YCbCr || width() < narrowest) return false;
    const auto is_sampled = [&](int component, int factor) {
        const jpeg_component_info& sampled = info_.comp_info[component];
        return sampled.h_samp_factor == factor && sampled.v_samp_factor == factor;
    };
    return is_sampled(0, 2) && is_sampled(1, 1) && is_sampled(2, 1);
}

bool JpegReader::start_unconverted() {
    info_.raw_data_out = TRUE;
    return jump_.completes([&] { jpeg_start_decompress(&info_); });
}

bool JpegReader::read_row_pairs(std::uint8_t* first, int count) {
    const std::size_t block_row = SubsampledImage::pair_size(width()) * DCTSIZE;
    return jump_.completes([&] {
        for (int i = 0; i < count / DCTSIZE; ++i)
            read_block_row(first + static_cast<std::size_t>(i) * block_row);
    });
}

std::string JpegReader::unsupported() {
    return reason_of(JERR_NOTIMPL);
}

bool JpegReader::has_inks() const {
    return info_.jpeg_color_space == JCS_CMYK || info_.jpeg_color_space == JCS_YCCK;
}

void JpegReader::read_row(std::uint8_t* to) {
    JSAMPROW target = has_inks() ? inks_.data() : to;
    jpeg_read_scanlines(&info_, &target, 1);
    if (has_inks()) to_rgb(inks_.data(), to, width());
}

void JpegReader::read_block_row(std::uint8_t* to) {
    std::array<JSAMPROW, 2 * DCTSIZE> luma;
    std::array<JSAMPROW, DCTSIZE> cb, cr;
    for (int i = 0; i < DCTSIZE; ++i, to += SubsampledImage::pair_size(width())) {
        const std::size_t stride = SubsampledImage::stride(width());
        luma[2 * i] = to;
        luma[2 * i + 1] = to + stride;
        cb[i] = to + 2 * stride;
        cr[i] = cb[i] + stride / 2;
    }
    std::array<JSAMPARRAY, 3> planes = {luma.data(), cb.data(), cr.data()};
    jpeg_read_raw_data(&info_, planes.data(), luma.size());
}

}  // namespace etalon
