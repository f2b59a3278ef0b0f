// Channels of an EXR file read only by OpenEXR, as another program would.
#pragma once

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include <map>
#include <string>
#include <vector>

namespace etalon::test {

/// Returns the names of all channels, in the order of the file, and their types.
inline std::map<std::string, Imf::PixelType> channel_types(const std::string& path) {
    const Imf::InputFile file(path.c_str());
    std::map<std::string, Imf::PixelType> types;
    const Imf::ChannelList& list = file.header().channels();
    for (auto c = list.begin(); c != list.end(); ++c) types[c.name()] = c.channel().type;
    return types;
}

/// Returns a channel's values by rows. Value is float or unsigned, as in the file.
template <class Value>
std::vector<Value> channel(const std::string& path, const std::string& name) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    const Imath::V2i size = window.size() + Imath::V2i(1);
    std::vector<Value> values(static_cast<std::size_t>(size.x) * size.y);
    const auto type = std::is_same_v<Value, float> ? Imf::FLOAT : Imf::UINT;
    Imf::FrameBuffer buffer;
    buffer.insert(name, Imf::Slice::Make(type, values.data(), window));
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return values;
}

}  // namespace etalon::test
