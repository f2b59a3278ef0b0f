#include "core/image/exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "core/image/io.h"
#include "tests/catch.h"
#include "tests/image/random_images.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Compares bits, so that NaNs are equal.
bool same_pixels(const RenderedImage& rendered, const Image& image) {
    const auto* values = std::get_if<std::vector<float>>(&image.pixels);
    return values && image.channels == 3 && values->size() == 3 * rendered.pixels.size() &&
           std::memcmp(values->data(), rendered.pixels.data(), 4 * values->size()) == 0;
}

}  // namespace

TEST_CASE("an EXR read back is the image, bit for bit") {
    const TemporaryFolder folder;
    const auto [width, height] =
        GENERATE(std::pair(1, 1), std::pair(37, 1), std::pair(1, 300), std::pair(67, 530));
    const RenderedImage rendered = random_image(width, height);
    REQUIRE(write_image(folder / "p.exr", rendered) == "");
    const Result<Image> read = read_image(folder / "p.exr");
    REQUIRE(read.error == "");
    CHECK(read.value.width == width);
    CHECK(read.value.height == height);
    CHECK(same_pixels(rendered, read.value));
    CHECK(folder.names() == std::vector<std::string>{"p.exr"});
}

TEST_CASE("noise is stored as it is, and what compresses is compressed") {
    constexpr int width = 100, rows = 5 * 16;
    RenderedImage rendered = random_image(width, rows);
    for (int i = 2 * 16 * width; i < 3 * 16 * width; ++i) {
        rendered.pixels[i] = Color(static_cast<float>(i % width) / width);
    }
    const Result<std::string> file = encode_exr(rendered);
    REQUIRE(file.error == "");
    const std::size_t block = 16 * width * sizeof(Color);
    CHECK(file.value.size() > 4 * block);
    CHECK(file.value.size() < 4 * block + block / 4);

    const TemporaryFolder folder;
    REQUIRE(write_image(folder / "p.exr", rendered) == "");
    CHECK(same_pixels(rendered, read_image(folder / "p.exr").value));
}

TEST_CASE("a crop is a data window inside the frame, and reads back as its own pixels") {
    const TemporaryFolder folder;
    const Imath::Box2i window = GENERATE(Imath::Box2i({0, 0}, {0, 0}), Imath::Box2i({9, 7}, {9, 7}),
                                         Imath::Box2i({3, 2}, {8, 5}));
    const RenderedImage rendered = random_image(10, 8, window);
    REQUIRE(write_image(folder / "p.exr", rendered) == "");
    const Result<Image> read = read_image(folder / "p.exr");
    REQUIRE(read.error == "");
    CHECK(read.value.width == window.size().x + 1);
    CHECK(read.value.height == window.size().y + 1);
    CHECK(same_pixels(rendered, read.value));
    const Imf::InputFile file((folder / "p.exr").c_str());
    CHECK(file.header().dataWindow() == window);
    CHECK(file.header().displayWindow() == Imath::Box2i({0, 0}, {9, 7}));
}

TEST_CASE("the file's header has OpenEXR's standard attributes") {
    const TemporaryFolder folder;
    REQUIRE(write_image(folder / "p.exr", random_image(4, 3)) == "");
    const Imf::InputFile file((folder / "p.exr").c_str());
    const Imf::Header& header = file.header();
    CHECK(header.compression() == Imf::ZIP_COMPRESSION);
    REQUIRE(Imf::hasChromaticities(header));
    const Imf::Chromaticities& c = Imf::chromaticities(header);
    CHECK(c.red == Imath::V2f(0.64F, 0.33F));
    CHECK(c.green == Imath::V2f(0.30F, 0.60F));
    CHECK(c.blue == Imath::V2f(0.15F, 0.06F));
    CHECK(c.white == Imath::V2f(0.3127F, 0.3290F));
    std::string channels;
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
        channels += i.name();
        CHECK(i.channel().type == Imf::FLOAT);
    }
    CHECK(channels == "BGR");
}

TEST_CASE("metadata keep their names, types and values") {
    const TemporaryFolder folder;
    Imath::M44f camera;
    for (int i = 0; i < 16; ++i) camera[i / 4][i % 4] = static_cast<float>(i) + 0.5F;
    RenderedImage rendered = random_image(4, 3);
    rendered.metadata = {{"software", std::string("Étalon 1")},
                         {"comments", std::string()},
                         {"samplesPerPixel", 64},
                         {"renderTimeSeconds", 1.25F},
                         {"worldToCamera", camera},
                         {"worldToNDC", camera * 2.0F}};
    REQUIRE(write_image(folder / "p.exr", rendered) == "");
    const Imf::InputFile file((folder / "p.exr").c_str());
    const Imf::Header& header = file.header();
    CHECK(header.typedAttribute<Imf::StringAttribute>("software").value() == "Étalon 1");
    CHECK(header.typedAttribute<Imf::StringAttribute>("comments").value().empty());
    CHECK(header.typedAttribute<Imf::IntAttribute>("samplesPerPixel").value() == 64);
    CHECK(header.typedAttribute<Imf::FloatAttribute>("renderTimeSeconds").value() == 1.25F);
    REQUIRE(Imf::hasWorldToCamera(header));
    CHECK(Imf::worldToCamera(header) == camera);
    REQUIRE(Imf::hasWorldToNDC(header));
    CHECK(Imf::worldToNDC(header) == camera * 2.0F);
}

TEST_CASE("metadata that contradict the header's own attributes are refused, not written") {
    const TemporaryFolder folder;
    RenderedImage rendered = random_image(4, 3);
    rendered.metadata = {{"channels", 3}};
    CHECK_THAT(write_image(folder / "p.exr", rendered),
               ContainsSubstring("p.exr") && ContainsSubstring("channels"));
    CHECK(folder.names().empty());
}

TEST_CASE("the same image makes the same file") {
    RenderedImage rendered = random_image(20, 20);
    rendered.metadata = {{"seed", 1}};
    const Result<std::string> first = encode_exr(rendered);
    REQUIRE(first.error == "");
    CHECK(first.value == encode_exr(rendered).value);
}
