#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfTestFile.h>

#include <new>
#include <stdexcept>
#include <string_view>

#include "core/image/exr.h"
#include "core/image/exr_pixels.h"
#include "core/image/lack_of_memory.h"

namespace etalon {
namespace {

constexpr int max_side = 65536;

/// Thrown if a file is complete but cannot be read; says why.
struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Returns a sentence for a failure, since OpenEXR's messages are about its internal steps.
std::string reason(const std::exception& e, const std::string& path) {
    if (dynamic_cast<const std::bad_alloc*>(&e)) return lack_of_memory;
    if (dynamic_cast<const Refused*>(&e)) return e.what();
    const std::string_view text = e.what();
    if (text.find("exceeds the maximum") != text.npos) return "larger than 65536 pixels";
    if (Imf::isDeepOpenExrFile(path.c_str())) return "deep images are not supported";
    return "the EXR is damaged or cut short";
}

/// Returns the file's channels that make up the image.
std::vector<std::string> image_channels(const Imf::ChannelList& stored) {
    const auto has = [&](const char* name) { return stored.findChannel(name) != nullptr; };
    if (has("R") || has("G") || has("B")) return {"R", "G", "B"};
    if (has("Y") && !has("RY") && !has("BY")) return {"Y"};
    std::string names;
    for (auto c = stored.begin(); c != stored.end(); ++c) names += std::string(" ") + c.name();
    throw Refused("expected channels R G B, or Y alone; it has" + names);
}

/// Refuses channels with fewer values than pixels, used or not: the size of a chunk would depend on
/// where it is.
void check_sampling(const Imf::ChannelList& stored) {
    for (auto c = stored.begin(); c != stored.end(); ++c) {
        if (c.channel().xSampling == 1 && c.channel().ySampling == 1) continue;
        throw Refused(std::string("channel ") + c.name() +
                      " is subsampled, which is not supported");
    }
}

bool has_display_colors(const Imf::Header& header) {
    const auto* stored = header.findTypedAttribute<Imf::IntAttribute>(display_colors_attribute);
    return stored && stored->value() == 1;
}

Image read_image_part(const std::string& path, Extent extent) {
    static const bool limited = (Imf::Header::setMaxImageSize(max_side, max_side),
                                 Imf::Header::setMaxTileSize(max_side, max_side), true);
    static_cast<void>(limited);
    Imf::InputFile file(path.c_str());
    const std::vector<std::string> names = image_channels(file.header().channels());
    check_sampling(file.header().channels());
    const Imath::Box2i window = file.header().dataWindow();
    const Imath::V2i size = window.size() + Imath::V2i(1);
    const int channels = static_cast<int>(names.size());
    const Encoding encoding =
        has_display_colors(file.header()) ? Encoding::display : Encoding::linear;
    Image image{size.x,
                size.y,
                channels,
                std::vector<float>(),
                encoding,
                window.min,
                file.header().displayWindow()};
    if (extent == Extent::whole) image.pixels = read_exr_pixels(path, file, names);
    return image;
}

}  // namespace

Result<Image> read_exr(const std::string& path, Extent extent) {
    try {
        return {read_image_part(path, extent), {}};
    } catch (const std::exception& e) {
        return {{}, reason(e, path)};
    }
}

}  // namespace etalon
