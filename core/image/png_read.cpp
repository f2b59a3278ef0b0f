#include "core/image/png.h"

#include <cstring>

#include "core/image/lack_of_memory.h"
#include "core/image/png_jump.h"
#include "core/image/read_by_rows.h"

namespace etalon {
namespace {

constexpr int max_side = 65536;

/// Decoder of one file. Its functions return false on failure; then reason() has a sentence, since
/// libpng's messages are about internal steps.
class PngReader {
  public:
    explicit PngReader(std::FILE* file) {
        jump_.completes([&] {
            png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &jump_, leave_png,
                                          ignore_png_warning);
            if (png_) info_ = png_create_info_struct(png_);
            if (info_) png_init_io(png_, file);
        });
    }
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    bool read_header() {
        return info_ && jump_.completes([&] {
            png_read_info(png_, info_);
            png_set_expand(png_);
            passes_ = png_set_interlace_handling(png_);
            png_read_update_info(png_, info_);
        });
    }

    /// Rows of a file that is not interlaced.
    bool read_rows(std::uint8_t* first, int count) {
        return jump_.completes([&] {
            for (int y = 0; y < count; ++y) png_read_row(png_, first + y * row_bytes(), nullptr);
        });
    }

    /// All rows of an interlaced file, whose passes fill them in turn.
    bool read_passes(std::uint8_t* first) {
        return jump_.completes([&] {
            for (int pass = 0; pass < passes_; ++pass) {
                for (int y = 0; y < height(); ++y) {
                    png_read_row(png_, first + static_cast<std::size_t>(y) * row_bytes(), nullptr);
                }
            }
            png_read_end(png_, nullptr);
        });
    }

    int width() const { return static_cast<int>(png_get_image_width(png_, info_)); }
    int height() const { return static_cast<int>(png_get_image_height(png_, info_)); }
    /// Returns the position of the first pixel in a larger image, if the file has it.
    std::optional<Imath::V2i> origin() const {
        png_int_32 x = 0, y = 0;
        int unit = PNG_OFFSET_PIXEL;
        const bool is_said = png_get_oFFs(png_, info_, &x, &y, &unit) != 0;
        if (!is_said || unit != PNG_OFFSET_PIXEL) return std::nullopt;
        return Imath::V2i(x, y);
    }
    int channels() const { return png_get_channels(png_, info_); }
    bool is_wide() const { return png_get_bit_depth(png_, info_) == 16; }
    bool is_interlaced() const { return passes_ > 1; }
    std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }

    std::string reason() const {
        const bool found_memory = info_ && !std::strstr(jump_.reason, "emory");
        return found_memory ? "the PNG is damaged or cut short" : lack_of_memory;
    }

  private:
    LibraryJump jump_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    int passes_ = 1;
};

bool read_bytes(PngReader& reader, PixelBytes& bytes) {
    if (reader.is_interlaced()) {
        bytes.resize(reader.row_bytes() * static_cast<std::size_t>(reader.height()));
        return reader.read_passes(bytes.data());
    }
    const auto read = [&](std::uint8_t* first, int count) {
        return reader.read_rows(first, count);
    };
    return read_by_rows(reader.row_bytes(), reader.height(), read, bytes);
}

/// Converts values of 16 bits, the higher byte first, to fractions of the largest.
std::vector<float> wide_values(const PixelBytes& bytes) {
    std::vector<float> values(bytes.size() / 2);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<float>(256 * bytes[2 * i] + bytes[2 * i + 1]) * (1.0F / 65535);
    }
    return values;
}

}  // namespace

Result<Image> read_png(std::FILE* file, Extent extent) {
    PngReader reader(file);
    if (!reader.read_header()) return {{}, reader.reason()};
    if (std::max(reader.width(), reader.height()) > max_side) {
        return {{}, "larger than 65536 pixels"};
    }
    Image image{reader.width(), reader.height(), reader.channels(), {},
                Encoding::srgb, reader.origin()};
    if (reader.is_wide()) image.pixels = std::vector<float>();
    if (extent == Extent::header) return {std::move(image), {}};
    PixelBytes bytes;
    if (!read_bytes(reader, bytes)) return {{}, reader.reason()};
    if (reader.is_wide())
        image.pixels = wide_values(bytes);
    else
        image.pixels = std::move(bytes);
    return {std::move(image), {}};
}

}  // namespace etalon
