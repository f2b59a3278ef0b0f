#include <limits>

#include "core/image/io.h"
#include "core/texture/texture_values.h"
#include "tests/catch.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Writes a PNG of the bytes 0 to 255 as they are, rows from the top.
void write_png(const std::string& path, int width, int height, const std::vector<Color>& bytes) {
    RenderedImage image{};
    image.width = width;
    image.height = height;
    image.window = {{0, 0}, {width - 1, height - 1}};
    image.display_colors = true;
    for (const Color& c : bytes) image.pixels.push_back(c / 255.0F);
    REQUIRE(write_image(path, image).empty());
}

/// An image of two rows and four columns, red above and green below.
struct SmallImage {
    TemporaryFolder folder;
    TextureImage image{folder / "small.png", Wrap::repeat, false, 1};

    SmallImage() {
        write_png(image.file, 4, 2,
                  {{10, 0, 0},
                   {20, 0, 0},
                   {30, 0, 0},
                   {40, 0, 0},  //
                   {0, 50, 0},
                   {0, 60, 0},
                   {0, 70, 0},
                   {0, 80, 0}});
    }
};

Color color_at(const TextureImage& image, double u, double v) {
    const Textures textures{{}, {ImageTexture<Color>{UvMapping{}, 0}}, {image}};
    std::vector<std::string> problems;
    const TextureValues values(textures, problems);
    REQUIRE(problems.empty());
    return values.color({Color(0.0F), 0}, {{u, v}, {}});
}

float number_at(const TextureImage& image, double u, double v) {
    const Textures textures{{ImageTexture<float>{UvMapping{}, 0}}, {}, {image}};
    std::vector<std::string> problems;
    const TextureValues values(textures, problems);
    REQUIRE(problems.empty());
    return values.number({0, 0}, {{u, v}, {}});
}

void check_bytes(const Color& found, const Color& bytes) {
    INFO(found * 255.0F << " for " << bytes);
    for (int k = 0; k < 3; ++k) CHECK(std::abs(found[k] * 255 - bytes[k]) < 1e-4);
}

}  // namespace

TEST_CASE("an image has its lower left texel at small coordinates", "[texture]") {
    const SmallImage small;
    check_bytes(color_at(small.image, 0.125, 0.25), {0, 50, 0});
    check_bytes(color_at(small.image, 0.875, 0.25), {0, 80, 0});
    check_bytes(color_at(small.image, 0.125, 0.75), {10, 0, 0});
    check_bytes(color_at(small.image, 0.875, 0.75), {40, 0, 0});
}

TEST_CASE("an image is interpolated between the centres of its texels", "[texture]") {
    const SmallImage small;
    check_bytes(color_at(small.image, 0.25, 0.25), {0, 55, 0});
    check_bytes(color_at(small.image, 0.375, 0.5), {10, 30, 0});
    check_bytes(color_at(small.image, 0.4375, 0.625), {16.875F, 15.625F, 0});
}

TEST_CASE("an image that repeats goes on with its other side", "[texture]") {
    const SmallImage small;
    check_bytes(color_at(small.image, 1, 0.75), {25, 0, 0});
    check_bytes(color_at(small.image, 0, 0.75), {25, 0, 0});
    check_bytes(color_at(small.image, 0.125, 1), {5, 25, 0});
    check_bytes(color_at(small.image, 5.875, -6.75), {0, 80, 0});
    check_bytes(color_at(small.image, -1e-20, 0.75), {25, 0, 0});
}

TEST_CASE("an image that is clamped goes on with its border", "[texture]") {
    SmallImage small;
    small.image.wrap = Wrap::clamp;
    check_bytes(color_at(small.image, 1, 0.75), {40, 0, 0});
    check_bytes(color_at(small.image, -7, 0.75), {10, 0, 0});
    check_bytes(color_at(small.image, 0.125, 1e30), {10, 0, 0});
    check_bytes(color_at(small.image, 0.125, -1e30), {0, 50, 0});
}

TEST_CASE("an image with a black border fades to it over half a texel", "[texture]") {
    SmallImage small;
    small.image.wrap = Wrap::black;
    check_bytes(color_at(small.image, 0.875, 0.75), {40, 0, 0});
    check_bytes(color_at(small.image, 1, 0.75), {20, 0, 0});
    check_bytes(color_at(small.image, 1, 0), {0, 20, 0});
    for (const double out : {1.125, 2.0, -0.125, -3.0, 1e30}) {
        check_bytes(color_at(small.image, out, 0.5), Color(0.0F));
        check_bytes(color_at(small.image, 0.5, out * 2), Color(0.0F));
    }
}

TEST_CASE("coordinates that are no numbers give a colour of the image", "[texture]") {
    SmallImage small;
    for (const Wrap wrap : {Wrap::repeat, Wrap::black, Wrap::clamp}) {
        small.image.wrap = wrap;
        CHECK(is_finite(color_at(small.image, nan_value, 0.5)));
        CHECK(is_finite(color_at(small.image, 0.5, infinity)));
    }
}

TEST_CASE("the values of an image are decoded, if at all, and then scaled", "[texture]") {
    SmallImage small;
    small.image.decode_srgb = true;
    const double encoded = (80 / 255.0 + 0.055) / 1.055;
    CHECK(std::abs(color_at(small.image, 0.875, 0.25).y - std::pow(encoded, 2.4)) < 1e-6);
    small.image.scale = 3;
    CHECK(std::abs(color_at(small.image, 0.875, 0.25).y - 3 * std::pow(encoded, 2.4)) < 1e-6);
    CHECK(std::abs(number_at(small.image, 0.125, 0.75) - 3 * (0.212671 * 10 / 255 / 12.92)) < 1e-7);
}

TEST_CASE("an image of three columns is shown as the four that pbrt-v3 makes of them",
          "[texture]") {
    const TemporaryFolder folder;
    const TextureImage image{folder / "three.png", Wrap::repeat, false, 2};
    write_png(image.file, 3, 1, {{51, 0, 0}, {204, 0, 0}, {128, 0, 255}});
    // Lanczos window of four texels, computed independently of the program.
    const Color left = color_at(image, 0.125, 0.5), right = color_at(image, 0.625, 0.5);
    CHECK(std::abs(left.x - 2 * 0.1913855) < 1e-3);
    CHECK(std::abs(right.x - 2 * 0.7550041) < 1e-3);
}

TEST_CASE("a texture of numbers shows an image's luminance", "[texture]") {
    const SmallImage small;
    CHECK(std::abs(number_at(small.image, 0.125, 0.75) - 0.212671F * 10 / 255) < 1e-6);
    CHECK(std::abs(number_at(small.image, 0.875, 0.25) - 0.715160F * 80 / 255) < 1e-6);
}

TEST_CASE("floats of an image are taken as they are", "[texture]") {
    const TemporaryFolder folder;
    RenderedImage image{};
    image.width = image.height = 1;
    image.window = {{0, 0}, {0, 0}};
    image.pixels = {{0.25F, 7, -1}};
    REQUIRE(write_image(folder / "one.exr", image).empty());
    const TextureImage texture{folder / "one.exr", Wrap::repeat, false, 2};
    CHECK(color_at(texture, 0.3, 0.8) == Color(0.5F, 14, -2));
    CHECK(std::abs(number_at(texture, 0.3, 0.8) - 2 * (0.212671F / 4 + 0.715160F * 7 - 0.072169F)) <
          1e-5);
}

TEST_CASE("grey stands in for an image that cannot be read, with one reason a file", "[texture]") {
    const TemporaryFolder folder;
    put(folder / "damaged.png", "no image");
    const Textures textures{
        {ImageTexture<float>{UvMapping{}, 0}},
        {ImageTexture<Color>{UvMapping{}, 1}, ImageTexture<Color>{UvMapping{}, 2}},
        {{folder / "damaged.png", Wrap::repeat, false, 3},
         {folder / "damaged.png", Wrap::clamp, false, 1},
         {folder / "missing.png", Wrap::black, true, 1}}};
    std::vector<std::string> problems;
    const TextureValues values(textures, problems);
    REQUIRE(problems.size() == 2);
    CHECK(problems[0].find(folder / "damaged.png") == 0);
    CHECK(problems[1].find(folder / "missing.png") == 0);
    const TexturePoint middle{{0.5, 0.5}, {}};
    CHECK(values.number({0, 0}, middle) == 1.5F);
    CHECK(values.color({Color(0.0F), 0}, middle) == Color(0.5F));
    CHECK(std::abs(values.color({Color(0.0F), 1}, middle).x - 0.2140411) < 1e-6);
}

TEST_CASE("an image that no texture shows is not read", "[texture]") {
    const Textures textures{{}, {}, {{"/nonexistent/image.png", Wrap::repeat, false, 1}}};
    std::vector<std::string> problems;
    const TextureValues values(textures, problems);
    CHECK(problems.empty());
}

TEST_CASE("Image: given an infinite texel, then it counts where it has a weight", "[texture]") {
    const TemporaryFolder folder;
    RenderedImage image{};
    image.width = image.height = 2;
    image.window = {{0, 0}, {1, 1}};
    image.pixels = {Color(std::numeric_limits<float>::infinity()), Color(1.0F), Color(2.0F),
                    Color(3.0F)};
    const TextureImage bordered{folder / "bright.exr", Wrap::black, false, 1};
    REQUIRE(write_image(bordered.file, image).empty());

    CHECK(color_at(bordered, 0.25, 0.25) == Color(2.0F));
    CHECK(number_at(bordered, 0.75, 0.75) == 1);
    CHECK(color_at(bordered, 5, 5) == Color(0.0F));
    CHECK(number_at(bordered, -1, 0.25) == 0);
    CHECK(std::isinf(number_at(bordered, 0.3, 0.7)));
}
