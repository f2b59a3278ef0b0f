#include <cmath>
#include <cstring>

#include "core/image/io.h"
#include "tests/catch.h"
#include "tests/image/random_images.h"
#include "tests/image/srgb_definition.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

std::vector<Color> pixels_of(const TemporaryFolder& folder, const std::string& name,
                             const std::string& content) {
    put(folder / name, content);
    const Result<Image> image = read_image(folder / name);
    REQUIRE(image.error == "");
    CHECK_FALSE(image.value.origin);
    return linear_pixels(image.value);
}

std::string text_of(const std::vector<int>& bytes) {
    return {bytes.begin(), bytes.end()};
}

}  // namespace

TEST_CASE("a PNG becomes linear: the image that it was made from, to half a step") {
    const TemporaryFolder folder;
    RenderedImage rendered{256, 1, {{0, 0}, {255, 0}}, {}, false, {}};
    for (int i = 0; i < 256; ++i) {
        rendered.pixels.push_back(Color(static_cast<float>(linear_of(i / 255.0)), 0, 1));
    }
    REQUIRE(write_image(folder / "p.png", rendered) == "");
    const Result<Image> read = read_image(folder / "p.png");
    REQUIRE(read.error == "");
    CHECK(linear_pixels(read.value) == rendered.pixels);
}

TEST_CASE("integers of eight and sixteen bits are sRGB") {
    const TemporaryFolder folder;
    const auto middle = static_cast<float>(linear_of(0x80 / 255.0));
    const std::vector<Color> eight =
        pixels_of(folder, "a.pgm", "P5 1 2 255\n" + text_of({51, 128}));
    CHECK(eight.at(0).x == static_cast<float>(linear_of(0.2)));
    CHECK(eight.at(1) == Color(middle));
    const std::vector<Color> sixteen =
        pixels_of(folder, "b.ppm", "P6 1 1 65535\n" + text_of({0, 0, 128, 128, 255, 255}));
    CHECK(sixteen.at(0).equalWithAbsError(Color(0, middle, 1), 1e-4F));
}

TEST_CASE("floats are linear already, with any values") {
    const TemporaryFolder folder;
    const float values[] = {-4, 1e20F, 0.125F};
    std::string data(sizeof values, 0);
    std::memcpy(data.data(), values, data.size());
    const std::vector<Color> pfm = pixels_of(folder, "p.pfm", "PF\n1 1\n-1.0\n" + data);
    CHECK(pfm.at(0) == Color(-4, 1e20F, 0.125F));
    const std::vector<Color> hdr = pixels_of(
        folder, "p.hdr",
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" + text_of({128, 64, 32, 130}));
    CHECK(hdr.at(0).x == Approx(2).epsilon(0.01));
}

TEST_CASE("an EXR is linear and has its data window") {
    const TemporaryFolder folder;
    const RenderedImage rendered = random_image(10, 8, {{3, 2}, {8, 5}});
    REQUIRE(write_image(folder / "p.exr", rendered) == "");
    const Result<Image> read = read_image(folder / "p.exr");
    REQUIRE(read.error == "");
    REQUIRE(read.value.origin);
    CHECK(*read.value.origin == Imath::V2i(3, 2));
    const std::vector<Color> pixels = linear_pixels(read.value);
    REQUIRE(pixels.size() == rendered.pixels.size());
    CHECK(std::memcmp(pixels.data(), rendered.pixels.data(), pixels.size() * sizeof(Color)) == 0);
}

TEST_CASE("an EXR has linear light, or is marked to have display values") {
    const TemporaryFolder folder;
    RenderedImage rendered = random_image(4, 3);
    rendered.pixels.assign(12, Color(0.5F, 2, -0.1F));
    rendered.display_colors = GENERATE(false, true);
    rendered.keep_display_values = GENERATE(false, true);
    REQUIRE(write_image(folder / "p.exr", rendered) == "");
    const Image image = read_image(folder / "p.exr").value;
    const bool kept = rendered.display_colors && rendered.keep_display_values;
    CHECK((image.encoding == (kept ? Encoding::display : Encoding::linear)));
    const bool is_decoded = rendered.display_colors && !kept;
    CHECK(image.color(1, 1).x == Approx(is_decoded ? 0.2140411 : 0.5));
    CHECK(image.color(1, 1).y == Approx(is_decoded ? 4.9538463 : 2));
    CHECK(image.color(1, 1).z == Approx(is_decoded ? -0.1 / 12.92 : -0.1));
    CHECK(display_pixels(image)[5].x == Approx(rendered.display_colors ? 0.5 : 0.7353570));
    CHECK(linear_pixels(image)[5].x == Approx(rendered.display_colors ? 0.2140411 : 0.5));
}
