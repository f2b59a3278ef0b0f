#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <bit>
#include <cstring>
#include <map>
#include <span>

#include "core/color/decode_srgb.h"
#include "core/image/exr.h"
#include "core/image/exr_zip.h"
#include "core/image/image.h"
#include "core/parallel/chunks.h"
#include "core/parallel/spares.h"

namespace etalon {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr const char* color_names[] = {"R", "G", "B"};

Imf::PixelType pixel_type(const Channel& channel) {
    return std::holds_alternative<std::vector<float>>(channel.values) ? Imf::FLOAT : Imf::UINT;
}

const std::uint8_t* data(const Channel& channel) {
    return std::visit([](const auto& v) { return reinterpret_cast<const std::uint8_t*>(v.data()); },
                      channel.values);
}

/// Output stream in memory. OpenEXR seeks back to fill in its table of blocks.
class MemoryStream : public Imf::OStream {
  public:
    explicit MemoryStream(std::string& bytes) : OStream("picture"), bytes_(bytes) {}

    void write(const char data[], int size) override {
        bytes_.replace(position_, static_cast<std::size_t>(size), data,
                       static_cast<std::size_t>(size));
        position_ += static_cast<std::size_t>(size);
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

  private:
    std::string& bytes_;
    std::size_t position_ = 0;
};

bool has_display_values(const RenderedImage& image) {
    return image.display_colors && image.keep_display_values;
}

Imf::Header make_header(const RenderedImage& image) {
    Imf::Header header({{0, 0}, {image.width - 1, image.height - 1}}, image.window);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* name : color_names) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    for (const Channel& c : image.channels) {
        header.channels().insert(c.name, Imf::Channel(pixel_type(c)));
    }
    Imf::addChromaticities(header, Imf::Chromaticities());  // the default is Rec. 709
    if (has_display_values(image)) header.insert(display_colors_attribute, Imf::IntAttribute(1));
    for (const auto& [name, value] : image.metadata) {
        std::visit(
            [&, key = name](const auto& v) {
                header.insert(key, Imf::TypedAttribute<std::decay_t<decltype(v)>>(v));
            },
            value);
    }
    return header;
}

/// A channel's 32-bit values, one for each pixel, and the byte stride.
struct Plane {
    const std::uint8_t* first;
    std::size_t stride;
    bool is_encoded = false;  ///< holds display values, but the file stores light
};

/// Returns the planes in the order of the file: by name.
std::map<std::string, Plane> planes_of(const RenderedImage& image) {
    std::map<std::string, Plane> planes;
    for (int k = 0; k < 3; ++k) {
        const auto* first = reinterpret_cast<const std::uint8_t*>(&(*image.pixels.data())[k]);
        planes[color_names[k]] = {first, sizeof(Color),
                                  image.display_colors && !image.keep_display_values};
    }
    for (const Channel& c : image.channels) planes[c.name] = {data(c), sizeof(float)};
    return planes;
}

/// Gathers and compresses blocks of rows. Keeps its memory from block to block.
class BlockWriter {
  public:
    /// Returns rows [begin, end) of the window as the file stores them.
    std::span<const std::uint8_t> operator()(const std::map<std::string, Plane>& planes,
                                             std::size_t width, std::size_t begin,
                                             std::size_t end) {
        gather(planes, width, begin, end);
        const auto bytes = std::as_bytes(std::span(block_));
        return zip_({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    }

  private:
    /// Copies the values row by row, and in each row plane by plane.
    void gather(const std::map<std::string, Plane>& planes, std::size_t width, std::size_t begin,
                std::size_t end) {
        static_assert(std::endian::native == std::endian::little, "as in the file");
        block_.resize((end - begin) * planes.size() * width);
        float* row = block_.data();
        for (std::size_t y = begin; y < end; ++y) {
            for (const auto& [name, plane] : planes) {
                const std::uint8_t* value = plane.first + y * width * plane.stride;
                for (std::size_t x = 0; x < width; ++x, value += plane.stride) {
                    std::memcpy(row + x, value, sizeof(float));
                }
                if (plane.is_encoded) decode_srgb({row, width});
                row += width;
            }
        }
    }

    std::vector<float> block_;  ///< the bits of all values, of integers too
    ExrZip zip_;
};

/// Compresses the blocks on all threads. OpenEXR would start threads of its own in addition, and
/// its compressor is slower.
std::vector<Bytes> zipped_blocks(const RenderedImage& image) {
    const std::map<std::string, Plane> planes = planes_of(image);
    const Imath::V2i last = image.window.size();
    const std::size_t width = static_cast<std::size_t>(last.x) + 1;
    const Chunks chunks(static_cast<std::size_t>(last.y) + 1, exr_zip_rows);
    std::vector<Bytes> blocks(chunks.number());
    Spares<BlockWriter> writers;
    chunks.parallel_for_each([&](std::size_t i, std::size_t begin, std::size_t end) {
        const auto loan = writers.lend();
        const auto block = (*loan)(planes, width, begin, end);
        blocks[i].assign(block.begin(), block.end());
    });
    return blocks;
}

/// Returns the file up to its table of blocks, whose entries are 0.
std::string start_of_file(const RenderedImage& image) {
    std::string bytes;
    MemoryStream stream(bytes);
    { const Imf::OutputFile file(stream, make_header(image)); }
    return bytes;
}

template <class T>
void put(T value, std::string& file, std::size_t position) {
    file.replace(position, sizeof value, reinterpret_cast<const char*>(&value), sizeof value);
}

/// Appends the blocks, each after its first row's number and its size, and completes the table.
void append_blocks(const std::vector<Bytes>& blocks, int first_row, std::string& file) {
    std::size_t entry = file.size() - blocks.size() * sizeof(std::uint64_t);
    std::size_t total = file.size();
    for (const Bytes& block : blocks) total += 2 * sizeof(std::int32_t) + block.size();
    file.reserve(total);
    for (const Bytes& block : blocks) {
        put(std::uint64_t(file.size()), file, entry);
        entry += sizeof(std::uint64_t);
        put(std::int32_t(first_row), file, file.size());
        put(static_cast<std::int32_t>(block.size()), file, file.size());
        file.append(reinterpret_cast<const char*>(block.data()), block.size());
        first_row += exr_zip_rows;
    }
}

}  // namespace

Result<std::string> encode_exr(const RenderedImage& image) {
    try {
        std::string file = start_of_file(image);
        append_blocks(zipped_blocks(image), image.window.min.y, file);
        return {std::move(file), {}};
    } catch (const std::exception& e) {
        return {{}, e.what()};
    }
}

}  // namespace etalon
