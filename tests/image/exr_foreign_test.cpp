// EXR files as written by other programs: half, integer, tiles, grey, layers.
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfTiledOutputPart.h>

#include "core/image/io.h"
#include "tests/catch.h"
#include "tests/image/foreign_exr.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

constexpr int width = 21, height = 300;
const Imath::Box2i window({-5, 7}, {-5 + width - 1, 7 + height - 1});

template <class T>
void write_exr(const std::string& path, const Layout& layout, Imf::PixelType type) {
    write_foreign_exr<T>(path, layout, type, window);
}

/// Writes a part's channel Y with the values of another channel.
void write_part(Imf::MultiPartOutputFile& file, int part, const std::string& values,
                const std::string& type) {
    const std::vector<float> plane = foreign_plane<float>({width, height}, values);
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice::Make(Imf::FLOAT, plane.data(), window));
    if (type == Imf::TILEDIMAGE) {
        Imf::TiledOutputPart output(file, part);
        output.setFrameBuffer(buffer);
        output.writeTiles(0, output.numXTiles() - 1, 0, output.numYTiles() - 1);
    } else {
        Imf::OutputPart output(file, part);
        output.setFrameBuffer(buffer);
        output.writePixels(height);
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
                wrong += c[static_cast<int>(k)] != (name == "-" ? 0 : foreign_value(x, y, name));
            }
        }
    }
    CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("half and float, scan lines and tiles, alpha and layers: R, G, B are read") {
    const TemporaryFolder folder;
    Layout layout{{"A", "B", "G", "N.X", "R"}};
    layout.compression = GENERATE(Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                  Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION);
    SECTION("scan lines") {}
    SECTION("scan lines from the bottom") {
        layout.order = Imf::DECREASING_Y;
    }
    SECTION("tiles") {
        layout.tiled = true;
    }
    SECTION("tiles from the bottom") {
        layout.tiled = true;
        layout.order = Imf::DECREASING_Y;
    }
    SECTION("tiles in the order they were written, with smaller levels") {
        layout.tiled = true;
        layout.order = Imf::RANDOM_Y;
        layout.levels = Imf::MIPMAP_LEVELS;
    }
    CAPTURE(layout.tiled, layout.order, layout.compression);
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
    const Imf::Compression compression = GENERATE(Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION);
    const Layout layout{{"R", "B", "X", "Y"}, false, Imf::INCREASING_Y, compression};
    write_exr<Imath::half>(folder / "rb.exr", layout, Imf::HALF);
    check_image(read_image(folder / "rb.exr"), {"R", "-", "B"});
}

TEST_CASE("of several parts the first is read") {
    const TemporaryFolder folder;
    const std::string type = GENERATE(Imf::SCANLINEIMAGE, Imf::TILEDIMAGE);
    std::vector<Imf::Header> headers(2, Imf::Header({{0, 0}, {99, 399}}, window));
    for (Imf::Header& header : headers) {
        header.setName(std::string(1, static_cast<char>('a' + (&header - headers.data()))));
        header.setType(type);
        if (type == Imf::TILEDIMAGE) header.setTileDescription({13, 17, Imf::ONE_LEVEL});
        header.compression() = Imf::ZIP_COMPRESSION;
        header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    }
    {
        Imf::MultiPartOutputFile file((folder / "parts.exr").c_str(), headers.data(), 2);
        write_part(file, 1, "Z", type);
        write_part(file, 0, "Y", type);
    }
    check_image(read_image(folder / "parts.exr"), {"Y"});
}

TEST_CASE("integer channels become floats") {
    const TemporaryFolder folder;
    const Imf::Compression compression = GENERATE(Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION);
    const Layout layout{{"R", "G", "B"}, false, Imf::INCREASING_Y, compression};
    write_exr<unsigned>(folder / "u.exr", layout, Imf::UINT);
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
    const std::string name = GENERATE("R", "X");
    Imf::Header header(8, 8);
    for (const char* full : {"G", "B"}) header.channels().insert(full, Imf::Channel(Imf::FLOAT));
    header.channels().insert(name, Imf::Channel(Imf::FLOAT, 2, 2));
    {
        Imf::OutputFile file((folder / "sub.exr").c_str(), header);
        Imf::FrameBuffer buffer;
        const Imath::Box2i all = header.dataWindow();
        for (const char* full : {"G", "B"}) {
            buffer.insert(full, Imf::Slice::Make(Imf::FLOAT, values.data(), all));
        }
        buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), all, 0, 0, 2, 2));
        file.setFrameBuffer(buffer);
        file.writePixels(8);
    }
    CHECK_THAT(read_image(folder / "sub.exr").error,
               ContainsSubstring("channel " + name + " is subsampled"));
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
