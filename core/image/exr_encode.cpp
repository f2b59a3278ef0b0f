#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "core/image/exr.h"
#include "core/image/exr_blocks.h"
#include "core/image/exr_zip.h"
#include "core/image/image.h"

namespace etalon {
namespace {

Imf::PixelType pixel_type(const Channel& channel) {
    return std::holds_alternative<std::vector<float>>(channel.values) ? Imf::FLOAT : Imf::UINT;
}

/// Output stream in memory. OpenEXR seeks back to fill in its table of blocks.
class MemoryStream : public Imf::OStream {
  public:
    explicit MemoryStream(std::string& bytes) : OStream("image"), bytes_(bytes) {}

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
    for (const char* name : exr_color_names)
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
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
void append_blocks(std::span<const std::vector<std::uint8_t>> blocks, int first_row,
                   std::string& file) {
    std::size_t entry = file.size() - blocks.size() * sizeof(std::uint64_t);
    std::size_t total = file.size();
    for (const auto& block : blocks) total += 2 * sizeof(std::int32_t) + block.size();
    file.reserve(total);
    for (const auto& block : blocks) {
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
        append_blocks(make_exr_blocks(image), image.window.min.y, file);
        return {std::move(file), {}};
    } catch (const std::exception& e) {
        return {{}, e.what()};
    }
}

}  // namespace etalon
