#include "tests/image/encoded_files.h"

#include <cstdlib>

#include "core/numerics/random.h"

namespace etalon::test {
namespace {

std::vector<std::uint8_t> noisy_row(Random& random, int y, int width, int channels) {
    std::vector<std::uint8_t> row;
    for (int x = 0; x < width; ++x) {
        for (int c = 0; c < channels; ++c) {
            row.push_back(static_cast<std::uint8_t>((c + 2) * x + 3 * y + random.index(24)));
        }
    }
    return row;
}

std::vector<std::uint8_t> random_bytes(Random& random, std::size_t count) {
    std::vector<std::uint8_t> bytes(count);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.bits());
    return bytes;
}

void apply(const JpegKind& kind, jpeg_compress_struct& info) {
    info.in_color_space = kind.given;
    jpeg_set_defaults(&info);
    jpeg_set_colorspace(&info, kind.stored);
    info.comp_info[0].h_samp_factor = info.comp_info[0].v_samp_factor = kind.sampling;
    if (kind.progressive) jpeg_simple_progression(&info);
    info.arith_code = kind.arithmetic ? TRUE : FALSE;
    info.restart_in_rows = kind.restart;
}

/// Chunks that say how colours below are stored, a palette, transparency and gamma, and where.
void add_chunks(const PngKind& kind, png_structp png, png_infop info, Random& random) {
    if (kind.color_type == PNG_COLOR_TYPE_PALETTE) {
        png_color colors[256];
        for (png_color& c : colors) {
            const auto bytes = random_bytes(random, 3);
            c = {bytes[0], bytes[1], bytes[2]};
        }
        png_set_PLTE(png, info, colors, 1 << kind.depth);
    }
    if (kind.transparent) {
        const auto alpha = random_bytes(random, std::size_t(1) << std::min(kind.depth, 8));
        const png_color_16 color = {0, 1, 1, 1, 1};
        png_set_tRNS(png, info, alpha.data(), static_cast<int>(alpha.size()) - 1, &color);
    }
    if (kind.gamma > 0) png_set_gAMA(png, info, kind.gamma);
    if (kind.place_unit >= 0) png_set_oFFs(png, info, 3, 2, kind.place_unit);
}

void append(png_structp png, png_bytep bytes, std::size_t size) {
    auto& file = *static_cast<std::string*>(png_get_io_ptr(png));
    file.append(reinterpret_cast<const char*>(bytes), size);
}

}  // namespace

std::vector<JpegKind> jpeg_kinds() {
    // An EXIF directory in Motorola's order with one entry: orientation 6, a quarter turn.
    const std::string turned(
        "Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0", 32);
    return {
        {"grey", JCS_GRAYSCALE, JCS_GRAYSCALE, 1, 1},
        {"halved colours", JCS_RGB, JCS_YCbCr, 3, 2},
        {"full colours", JCS_RGB, JCS_YCbCr, 3, 1},
        {"progressive", JCS_RGB, JCS_YCbCr, 3, 2, true},
        {"progressive grey", JCS_GRAYSCALE, JCS_GRAYSCALE, 1, 1, true},
        {"arithmetic", JCS_RGB, JCS_YCbCr, 3, 2, false, true},
        {"RGB", JCS_RGB, JCS_RGB, 3, 1},
        {"restarts", JCS_RGB, JCS_YCbCr, 3, 2, false, false, 1},
        {"turned", JCS_RGB, JCS_YCbCr, 3, 2, false, false, 0, turned},
        {"CMYK", JCS_CMYK, JCS_CMYK, 4, 1},
        {"YCCK", JCS_CMYK, JCS_YCCK, 4, 2},
        {"two channels", JCS_UNKNOWN, JCS_UNKNOWN, 2, 1},
    };
}

std::string encoded_jpeg(const JpegKind& kind, int width, int height) {
    jpeg_compress_struct info = {};
    jpeg_error_mgr errors = {};
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    unsigned char* data = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&info, &data, &size);
    info.image_width = static_cast<JDIMENSION>(width);
    info.image_height = static_cast<JDIMENSION>(height);
    info.input_components = kind.channels;
    apply(kind, info);
    jpeg_start_compress(&info, TRUE);
    if (!kind.marker.empty()) {
        jpeg_write_marker(&info, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(kind.marker.data()),
                          static_cast<unsigned>(kind.marker.size()));
    }
    Random random(3);
    for (int y = 0; y < height; ++y) {
        std::vector<std::uint8_t> row = noisy_row(random, y, width, kind.channels);
        JSAMPROW first = row.data();
        jpeg_write_scanlines(&info, &first, 1);
    }
    jpeg_finish_compress(&info);
    std::string file(reinterpret_cast<const char*>(data), size);
    jpeg_destroy_compress(&info);
    std::free(data);
    return file;
}

std::string PngKind::name() const {
    return "type " + std::to_string(color_type) + ", " + std::to_string(depth) + " bits" +
           (transparent ? ", transparent" : "") + (interlaced ? ", interlaced" : "") + ", gamma " +
           std::to_string(gamma);
}

std::vector<PngKind> png_kinds() {
    std::vector<PngKind> kinds;
    for (const int type : {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_PALETTE,
                           PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB_ALPHA}) {
        for (const int depth : {1, 2, 4, 8, 16}) {
            if (depth < 8 && type != PNG_COLOR_TYPE_GRAY && type != PNG_COLOR_TYPE_PALETTE)
                continue;
            if (depth > 8 && type == PNG_COLOR_TYPE_PALETTE) continue;
            for (const bool transparent : {false, true}) {
                if (transparent && (type & PNG_COLOR_MASK_ALPHA) != 0) continue;
                for (const bool interlaced : {false, true}) {
                    for (const double gamma : {0.0, 1.0, 0.6}) {
                        kinds.push_back({type, depth, transparent, interlaced, gamma});
                    }
                }
            }
        }
    }
    return kinds;
}

std::string encoded_png(const PngKind& kind, int width, int height) {
    std::string file;
    Random random(4);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &file, append, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
                 kind.depth, kind.color_type,
                 kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    add_chunks(kind, png, info, random);
    png_write_info(png, info);
    const std::size_t row = png_get_rowbytes(png, info);
    std::vector<std::uint8_t> bytes = random_bytes(random, row * static_cast<std::size_t>(height));
    std::vector<png_bytep> rows;
    for (int y = 0; y < height; ++y) rows.push_back(&bytes[static_cast<std::size_t>(y) * row]);
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return file;
}

}  // namespace etalon::test
