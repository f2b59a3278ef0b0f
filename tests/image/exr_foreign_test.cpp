// EXR files as written by other programs: half, integer, tiles, grey, layers.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include "core/image/io.h"
#include "tests/catch.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

constexpr int width = 21, height = 300;
const Imath::Box2i window({-5, 7}, {-5 + width - 1, 7 + height - 1});

/// The value of a channel, distinct and exact in half precision.
float value(int x, int y, const std::string& channel) {
    return static_cast<float>((x + 3 * y) % 64) + static_cast<float>(channel[0] % 8) / 8;
}

template <class T>
std::vector<T> plane(const std::string& channel) {
    std::vector<T> values;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            values.push_back(static_cast<T>(value(x, y, channel)));
        }
    }
    return values;
}

struct Layout {
    std::vector<std::string> channels;
    bool tiled = false;
    Imf::LineOrder order = Imf::INCREASING_Y;
    Imf::Compression compression = Imf::PIZ_COMPRESSION;
};

template <class T>
void write_exr(const std::string& path, const Layout& layout, Imf::PixelType type) {
    Imf::Header header({{0, 0}, {99, 399}}, window);
    header.lineOrder() = layout.order;
    header.compression() = layout.compression;
    std::vector<std::vector<T>> planes;
    Imf::FrameBuffer buffer;
    for (const std::string& name : layout.channels) {
        header.channels().insert(name, Imf::Channel(type));
        planes.push_back(plane<T>(name));
        buffer.insert(name, Imf::Slice::Make(type, planes.back().data(), window));
    }
    if (layout.tiled) {
        header.setTileDescription({13, 17, Imf::ONE_LEVEL});
        Imf::TiledOutputFile file(path.c_str(), header);
        file.setFrameBuffer(buffer);
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    } else {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(height);
    }
}

void check_image(const Result<Image>& read, const std::vector<std::string>& channels) {
    REQUIRE(read.error == "");
    REQUIRE(read.value.width == width);
    REQUIRE(read.value.height == height);
    REQUIRE(read.value.channels == static_cast<int>(channels.size()));
    int wrong = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Color c = read.value.color(x, y);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::string& name = channels[channels.size() == 1 ? 0 : k];
                wrong += c[static_cast<int>(k)] != (name == "-" ? 0 : value(x, y, name));
            }
        }
    }
    CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("half and float, scan lines and tiles, alpha and layers: R, G, B are read") {
    const TemporaryFolder folder;
    Layout layout{{"A", "B", "G", "N.X", "R"}};
    SECTION("scan lines") {}
    SECTION("scan lines from the bottom") {
        layout.order = Imf::DECREASING_Y;
    }
    SECTION("tiles") {
        layout.tiled = true;
    }
    SECTION("tiles from the bottom, ZIP") {
        layout = {layout.channels, true, Imf::DECREASING_Y, Imf::ZIP_COMPRESSION};
    }
    write_exr<float>(folder / "float.exr", layout, Imf::FLOAT);
    write_exr<Imath::half>(folder / "half.exr", layout, Imf::HALF);
    check_image(read_image(folder / "half.exr"), {"R", "G", "B"});
    check_image(read_image(folder / "float.exr"), {"R", "G", "B"});
}

TEST_CASE("a single luminance channel is a grey image") {
    const TemporaryFolder folder;
    write_exr<float>(folder / "y.exr", {{"Y", "A"}}, Imf::FLOAT);
    check_image(read_image(folder / "y.exr"), {"Y"});
}

TEST_CASE("a colour channel the file lacks is black") {
    const TemporaryFolder folder;
    write_exr<float>(folder / "rb.exr", {{"R", "B"}}, Imf::FLOAT);
    check_image(read_image(folder / "rb.exr"), {"R", "-", "B"});
}

TEST_CASE("integer channels become floats") {
    const TemporaryFolder folder;
    write_exr<unsigned>(folder / "u.exr", {{"R", "G", "B"}}, Imf::UINT);
    const Result<Image> read = read_image(folder / "u.exr");
    REQUIRE(read.error == "");
    CHECK(read.value.color(5, 6) == Color(23, 23, 23));
}

TEST_CASE("a file without R, G, B or Y is an error that names its channels") {
    const TemporaryFolder folder;
    write_exr<float>(folder / "z.exr", {{"Z", "N.X"}}, Imf::FLOAT);
    CHECK_THAT(read_image(folder / "z.exr").error,
               ContainsSubstring("z.exr") && ContainsSubstring("expected channels R G B") &&
                   ContainsSubstring("N.X Z"));
}

TEST_CASE("channels with fewer values than pixels are refused by name") {
    const TemporaryFolder folder;
    const std::vector<float> values(8 * 8, 0.5F);
    Imf::Header header(8, 8);
    for (const char* name : {"G", "B"}) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    header.channels().insert("R", Imf::Channel(Imf::FLOAT, 2, 2));
    {
        Imf::OutputFile file((folder / "sub.exr").c_str(), header);
        Imf::FrameBuffer buffer;
        const Imath::Box2i all = header.dataWindow();
        for (const char* name : {"G", "B"}) {
            buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), all));
        }
        buffer.insert("R", Imf::Slice::Make(Imf::FLOAT, values.data(), all, 0, 0, 2, 2));
        file.setFrameBuffer(buffer);
        file.writePixels(8);
    }
    CHECK_THAT(read_image(folder / "sub.exr").error, ContainsSubstring("channel R is subsampled"));
}

TEST_CASE("luminance with chroma is refused rather than read without its colours") {
    const TemporaryFolder folder;
    const std::vector<Imf::Rgba> pixels(8 * 8);
    {
        Imf::RgbaOutputFile file((folder / "yc.exr").c_str(), 8, 8, Imf::WRITE_YC);
        file.setFrameBuffer(pixels.data(), 1, 8);
        file.writePixels(8);
    }
    CHECK_THAT(read_image(folder / "yc.exr").error, ContainsSubstring("it has BY RY Y"));
}
