#include <zlib.h>

#include "core/image/png.h"
#include "core/image/png_jump.h"

namespace etalon {
namespace {

/// Writer of one file into memory. Its functions return false on failure.
class PngWriter {
  public:
    PngWriter() {
        jump_.completes([&] {
            png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &jump_, leave_png,
                                           ignore_png_warning);
            if (png_) info_ = png_create_info_struct(png_);
        });
    }
    ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    bool write(std::span<const std::uint8_t> rgb, int width, int height, const PngFacts& facts) {
        const std::vector<png_text> texts = texts_of(facts);
        return info_ && jump_.completes([&] {
            png_set_write_fn(png_, this, append, nullptr);
            const auto& origin = facts.origin;
            if (origin) png_set_oFFs(png_, info_, origin->x, origin->y, PNG_OFFSET_PIXEL);
            png_set_text(png_, info_, texts.data(), static_cast<int>(texts.size()));
            write_header(width, height);
            const std::size_t row = 3 * static_cast<std::size_t>(width);
            for (int y = 0; y < height; ++y) png_write_row(png_, &rgb[y * row]);
            png_write_end(png_, info_);
        });
    }

    std::string& file() { return file_; }
    std::string reason() const { return info_ ? jump_.reason : "not enough memory"; }

  private:
    /// libpng's view of the texts, which it only reads.
    static std::vector<png_text> texts_of(const PngFacts& facts) {
        std::vector<png_text> texts;
        for (const auto& [keyword, text] : facts.texts) {
            png_text& t = texts.emplace_back();
            t = {};
            t.compression = PNG_ITXT_COMPRESSION_NONE;
            t.key = const_cast<char*>(keyword.c_str());
            t.text = const_cast<char*>(text.c_str());
        }
        return texts;
    }

    /// Differences from the left, of which zlib looks for runs only: of rendered images as small as
    /// higher levels make them without a filter, in a third of the time.
    void write_header(int width, int height) {
        png_set_compression_level(png_, 1);
        png_set_compression_strategy(png_, Z_RLE);
        png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
        png_set_IHDR(png_, info_, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
                     8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                     PNG_FILTER_TYPE_DEFAULT);
        png_set_sRGB_gAMA_and_cHRM(png_, info_, PNG_sRGB_INTENT_ABSOLUTE);
        png_write_info(png_, info_);
    }

    static void append(png_structp png, png_bytep bytes, std::size_t size) {
        bool appended = true;
        try {
            auto& writer = *static_cast<PngWriter*>(png_get_io_ptr(png));
            writer.file_.append(reinterpret_cast<const char*>(bytes), size);
        } catch (const std::exception&) {
            appended = false;  // the jump must not leave the handler's scope
        }
        if (!appended) png_error(png, "not enough memory");
    }

    LibraryJump jump_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::string file_;
};

}  // namespace

Result<std::string> encode_png(std::span<const std::uint8_t> rgb, int width, int height,
                               const PngFacts& facts) {
    PngWriter writer;
    if (!writer.write(rgb, width, height, facts)) return {{}, writer.reason()};
    return {std::move(writer.file()), {}};
}

}  // namespace etalon
