// EXR files with OpenEXR's own writers, in the layouts that other programs use.
#pragma once

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include <string>
#include <vector>

namespace etalon::test {

struct Layout {
    std::vector<std::string> channels;
    bool tiled = false;
    Imf::LineOrder order = Imf::INCREASING_Y;
    Imf::Compression compression = Imf::PIZ_COMPRESSION;
    Imath::V2i tile = {13, 17};
    Imf::LevelMode levels = Imf::ONE_LEVEL;
};

/// The value of a channel at a pixel, counted from the corner of the data window. Distinct, and
/// exact in half precision.
inline float foreign_value(int x, int y, const std::string& channel) {
    return static_cast<float>((x + 3 * y) % 64) + static_cast<float>(channel[0] % 8) / 8;
}

/// Returns a channel's values, row by row.
template <class T>
std::vector<T> foreign_plane(const Imath::V2i& size, const std::string& channel) {
    std::vector<T> values;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            values.push_back(static_cast<T>(foreign_value(x, y, channel)));
        }
    }
    return values;
}

inline void write_tiles(Imf::TiledOutputFile& file) {
    for (int level = 0; level < file.numLevels(); ++level) {
        file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
    }
}

/// Writes an EXR whose values of type T are foreign_value(); smaller levels are its corner.
template <class T>
void write_foreign_exr(const std::string& path, const Layout& layout, Imf::PixelType type,
                       const Imath::Box2i& window) {
    Imf::Header header({{0, 0}, {99, 399}}, window);
    header.lineOrder() = layout.order;
    header.compression() = layout.compression;
    std::vector<std::vector<T>> planes;
    Imf::FrameBuffer buffer;
    for (const std::string& name : layout.channels) {
        header.channels().insert(name, Imf::Channel(type));
        planes.push_back(foreign_plane<T>(window.size() + Imath::V2i(1), name));
        buffer.insert(name, Imf::Slice::Make(type, planes.back().data(), window));
    }
    if (layout.tiled) {
        const auto side = [](int pixels) { return static_cast<unsigned>(pixels); };
        header.setTileDescription({side(layout.tile.x), side(layout.tile.y), layout.levels});
        Imf::TiledOutputFile file(path.c_str(), header);
        file.setFrameBuffer(buffer);
        write_tiles(file);
    } else {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(window.size().y + 1);
    }
}

}  // namespace etalon::test
