#include "core/image/encode.h"
#include "core/image/io.h"
#include "tests/catch.h"
#include "tests/image/encoded_files.h"
#include "tests/image/random_images.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

std::vector<std::uint8_t> bytes_of(const Image& image) {
    const auto& bytes = std::get<PixelBytes>(image.pixels);
    return {bytes.begin(), bytes.end()};
}

}  // namespace

TEST_CASE("a PNG read back has the bytes of the encoding, for any values") {
    const TemporaryFolder folder;
    RenderedImage rendered = random_image(67, 41);
    rendered.display_colors = GENERATE(false, true);
    for (std::size_t i = 0; i < 1000; ++i) {  // ordinary values beside the wild ones
        rendered.pixels[i] = Color(static_cast<float>(i) / 1000, 0.5F, 0.18F);
    }
    REQUIRE(write_image(folder / "p.PNG", rendered, 0.5) == "");
    const Result<Image> read = read_image(folder / "p.PNG");
    REQUIRE(read.error == "");
    CHECK(read.value.width == 67);
    CHECK(read.value.height == 41);
    CHECK(read.value.channels == 3);
    CHECK(bytes_of(read.value) == display_bytes(rendered, 0.5));
    CHECK(folder.names() == std::vector<std::string>{"p.PNG"});
}

TEST_CASE("a PNG is marked as sRGB") {
    const TemporaryFolder folder;
    REQUIRE(write_image(folder / "p.png", random_image(4, 3)) == "");
    const std::string file = content_of(folder / "p.png");
    CHECK(file.substr(1, 3) == "PNG");
    CHECK(file.find(std::string("\0\0\0\1sRGB", 8)) < file.find("IDAT"));  // a chunk of one byte
}

TEST_CASE("a crop's PNG holds the crop") {
    const TemporaryFolder folder;
    const RenderedImage rendered = random_image(10, 8, {{3, 2}, {8, 5}});
    REQUIRE(write_image(folder / "p.png", rendered) == "");
    const Result<Image> read = read_image(folder / "p.png");
    REQUIRE(read.error == "");
    CHECK(read.value.width == 6);
    CHECK(read.value.height == 4);
    CHECK(read.value.origin == Imath::V2i(3, 2));
    CHECK(bytes_of(read.value) == display_bytes(rendered, 0));
    REQUIRE(write_image(folder / "whole.png", random_image(10, 8)) == "");
    CHECK_FALSE(read_image(folder / "whole.png").value.origin);
}

TEST_CASE("a PNG's place on paper, in micrometres, is none in an image") {
    const TemporaryFolder folder;
    PngKind kind;
    kind.place_unit = PNG_OFFSET_MICROMETER;
    put(folder / "p.png", encoded_png(kind, 5, 4));
    const Result<Image> on_paper = read_image(folder / "p.png");
    REQUIRE(on_paper.error == "");
    CHECK_FALSE(on_paper.value.origin);
    kind.place_unit = PNG_OFFSET_PIXEL;
    put(folder / "p.png", encoded_png(kind, 5, 4));
    CHECK(read_image(folder / "p.png").value.origin == Imath::V2i(3, 2));
}
