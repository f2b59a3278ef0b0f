#include "core/image/exr_pixels.h"

#include <Imath/half.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfVersion.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "core/image/exr_chunks.h"

namespace etalon {
namespace {

/// A channel of the file, and its place in a pixel if it is read.
struct StoredChannel {
    exr_pixel_type_t type;
    std::optional<std::size_t> place;
};

std::vector<StoredChannel> stored_channels(const ExrChunks& file,
                                           const std::vector<std::string>& names) {
    std::vector<StoredChannel> channels;
    for (const exr_attr_chlist_entry_t& channel : file.channels()) {
        const auto name = std::find(names.begin(), names.end(), channel.name.str);
        channels.push_back({channel.pixel_type, std::nullopt});
        if (name != names.end()) channels.back().place = name - names.begin();
    }
    return channels;
}

std::size_t bytes_of(exr_pixel_type_t type) {
    return type == EXR_PIXEL_HALF ? 2 : 4;
}

/// Converts `count` values of type T to every `stride`-th float.
template <class T>
void convert(const std::uint8_t* from, std::size_t count, float* to, std::size_t stride) {
    for (std::size_t i = 0; i < count; ++i, from += sizeof(T)) {
        T value;
        std::memcpy(&value, from, sizeof(T));
        to[i * stride] = static_cast<float>(value);
    }
}

void convert(exr_pixel_type_t type, const std::uint8_t* from, std::size_t count, float* to,
             std::size_t stride) {
    switch (type) {
        case EXR_PIXEL_HALF:
            return convert<Imath::half>(from, count, to, stride);
        case EXR_PIXEL_FLOAT:
            return convert<float>(from, count, to, stride);
        case EXR_PIXEL_UINT:
            return convert<std::uint32_t>(from, count, to, stride);
        default:
            throw std::runtime_error("a channel of another type");
    }
}

/// Interleaves the chunks of a file. Memory grows with the contents of the file, not its header.
class ChunkReader {
  public:
    ChunkReader(const ExrChunks& file, const Imath::V2i& size,
                const std::vector<std::string>& names)
        : file_(file),
          channels_(stored_channels(file, names)),
          width_(static_cast<std::size_t>(size.x)),
          names_(names.size()) {
        pixels_.reserve(width_ * static_cast<std::size_t>(size.y) * names_);
    }

    std::vector<float> operator()() && {
        file_.for_each([&](const ExrChunk& chunk) { add(chunk); });
        return std::move(pixels_);
    }

  private:
    void add(const ExrChunk& chunk) {
        const ExrBytes bytes = file_.decode(chunk);
        const auto x = static_cast<std::size_t>(chunk.corner.x);
        const auto y = static_cast<std::size_t>(chunk.corner.y);
        const auto rows = static_cast<std::size_t>(chunk.info.height);
        pixels_.resize((y + rows) * width_ * names_);
        const std::uint8_t* from = bytes.get();
        for (std::size_t row = 0; row < rows; ++row) {
            from = add_row(from, chunk.info.width, &pixels_[((y + row) * width_ + x) * names_]);
        }
    }

    /// Adds a row of a chunk. Returns the end of its bytes.
    const std::uint8_t* add_row(const std::uint8_t* from, int count, float* to) {
        const auto width = static_cast<std::size_t>(count);
        for (const StoredChannel& channel : channels_) {
            if (channel.place) convert(channel.type, from, width, to + *channel.place, names_);
            from += width * bytes_of(channel.type);
        }
        return from;
    }

    const ExrChunks& file_;
    std::vector<StoredChannel> channels_;
    std::size_t width_, names_;
    std::vector<float> pixels_;
};

/// Reads a few rows at a time, so that memory grows with the contents of the file, not its header.
std::vector<float> read_rows(Imf::InputFile& file, const std::vector<std::string>& names) {
    constexpr int rows_at_once = 256;  // the most a compressed block has (DWAB)
    const Imath::Box2i window = file.header().dataWindow();
    const std::size_t row = names.size() * (static_cast<std::size_t>(window.size().x) + 1);
    std::vector<float> pixels;
    pixels.reserve(row * (static_cast<std::size_t>(window.size().y) + 1));
    for (int y = window.min.y; y <= window.max.y; y += rows_at_once) {
        const int last = std::min(y + rows_at_once - 1, window.max.y);
        const std::size_t done = pixels.size();
        pixels.resize(done + row * static_cast<std::size_t>(last - y + 1));
        const Imath::Box2i strip({window.min.x, y}, {window.max.x, last});
        Imf::FrameBuffer buffer;
        for (std::size_t k = 0; k < names.size(); ++k) {
            buffer.insert(names[k], Imf::Slice::Make(Imf::FLOAT, &pixels[done + k], strip,
                                                     names.size() * sizeof(float)));
        }
        file.setFrameBuffer(buffer);
        file.readPixels(y, last);
    }
    return pixels;
}

bool is_deep(const Imf::InputFile& file) {
    const int flags = file.version();
    return Imf::isNonImage(flags) &&
           (!Imf::isMultiPart(flags) || Imf::isDeepData(file.header().type()));
}

bool is_tiled(const Imf::InputFile& file) {
    const int flags = file.version();
    return Imf::isMultiPart(flags) ? Imf::isTiled(file.header().type()) : Imf::isTiled(flags);
}

}  // namespace

std::vector<float> read_exr_pixels(const std::string& path, Imf::InputFile& file,
                                   const std::vector<std::string>& names) {
    if (is_deep(file)) return read_rows(file, names);  // OpenEXR merges the samples of a pixel
    const Imath::V2i size = file.header().dataWindow().size() + Imath::V2i(1);
    const ExrChunks chunks(path, is_tiled(file));
    if (chunks.size() != size) throw std::runtime_error("another size");
    if (chunks.can_decode()) return ChunkReader(chunks, size, names)();
    chunks.for_each([](const ExrChunk&) {});  // which checks their sizes
    return read_rows(file, names);
}

}  // namespace etalon
