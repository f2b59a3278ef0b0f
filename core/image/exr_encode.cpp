#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "core/image/exr.h"

namespace etalon {
namespace {

constexpr const char* color_names[] = {"R", "G", "B"};

Imf::PixelType pixel_type(const Channel& channel) {
    return std::holds_alternative<std::vector<float>>(channel.values) ? Imf::FLOAT : Imf::UINT;
}

const void* data(const Channel& channel) {
    return std::visit([](const auto& v) -> const void* { return v.data(); }, channel.values);
}

/// Stream in memory. OpenEXR goes back to fill in its table of blocks: writing may replace bytes.
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

Imf::Header make_header(const RenderedImage& image) {
    Imf::Header header({{0, 0}, {image.width - 1, image.height - 1}}, image.window);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* name : color_names) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    for (const Channel& c : image.channels) {
        header.channels().insert(c.name, Imf::Channel(pixel_type(c)));
    }
    Imf::addChromaticities(header, Imf::Chromaticities());  // the default is Rec. 709
    if (image.display_colors) header.insert(display_colors_attribute, Imf::IntAttribute(1));
    for (const auto& [name, value] : image.metadata) {
        std::visit(
            [&, key = name](const auto& v) {
                header.insert(key, Imf::TypedAttribute<std::decay_t<decltype(v)>>(v));
            },
            value);
    }
    return header;
}

void write_pixels(const RenderedImage& image, Imf::OutputFile& file) {
    Imf::FrameBuffer buffer;
    for (int k = 0; k < 3; ++k) {
        const float* first = &image.pixels[0][k];
        buffer.insert(color_names[k],
                      Imf::Slice::Make(Imf::FLOAT, first, image.window, sizeof(Color)));
    }
    for (const Channel& c : image.channels) {
        buffer.insert(c.name, Imf::Slice::Make(pixel_type(c), data(c), image.window));
    }
    file.setFrameBuffer(buffer);
    file.writePixels(image.window.max.y - image.window.min.y + 1);
}

}  // namespace

Result<std::string> encode_exr(const RenderedImage& image) {
    try {
        std::string bytes;
        bytes.reserve(image.pixels.size() * sizeof(Color));
        MemoryStream stream(bytes);
        {
            Imf::OutputFile file(stream, make_header(image));
            write_pixels(image, file);
        }  // completes the file
        return {std::move(bytes), {}};
    } catch (const std::exception& e) {
        return {{}, e.what()};
    }
}

}  // namespace etalon
