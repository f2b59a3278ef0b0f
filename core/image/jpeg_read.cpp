#include "core/image/jpeg_read.h"

#include "core/image/jpeg_reader.h"
#include "core/image/read_by_rows.h"

namespace etalon {
namespace {

/// Reads the header, which must be of a kind that is supported. Returns the reason of a failure,
/// or an empty string.
std::string read_header(JpegReader& reader) {
    constexpr int most_channels = 4;
    if (!reader.read_header()) return reader.reason();
    return reader.channels() > most_channels ? JpegReader::unsupported() : "";
}

Image header_of(const JpegReader& reader) {
    return {reader.width(), reader.height(), reader.channels(), {}, Encoding::srgb, {}};
}

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

std::string read_pixels(JpegReader& reader, SubsampledImage& image) {
    if (!reader.start_unconverted()) return reader.reason();
    const auto read = [&](std::uint8_t* first, int count) {
        return reader.read_row_pairs(first, count);
    };
    const int pairs = (image.height + 15) / 16 * 8;
    if (!read_by_rows(SubsampledImage::pair_size(image.width), pairs, read, image.pairs))
        return reader.reason();
    return {};
}

}  // namespace

Result<Image> read_jpeg(std::FILE* file, Extent extent) {
    JpegReader reader(file, extent);
    Result<Image> image{{}, read_header(reader)};
    if (!image) return image;
    image.value = header_of(reader);
    if (extent == Extent::whole) image.error = read_pixels(reader, image.value);
    if (!image) image.value = {};
    return image;
}

Result<CompactImage> read_compact_jpeg(std::FILE* file) {
    JpegReader reader(file, Extent::whole);
    Result<CompactImage> image{{}, read_header(reader)};
    if (!image) return image;
    if (reader.is_subsampled())
        image.value = SubsampledImage{reader.width(), reader.height(), {}};
    else
        image.value = header_of(reader);
    image.error =
        std::visit([&](auto& pixels) { return read_pixels(reader, pixels); }, image.value);
    if (!image) image.value = {};
    return image;
}

}  // namespace etalon
