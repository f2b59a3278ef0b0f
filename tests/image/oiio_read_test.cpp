// Files of other formats, given as bytes.
#include <cstring>

#include "core/image/announced_size.h"
#include "core/image/io.h"
#include "tests/catch.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

using Bytes = PixelBytes;
using Floats = std::vector<float>;

std::string text_of(const Bytes& bytes) {
    return {bytes.begin(), bytes.end()};
}

Image read(const TemporaryFolder& folder, const std::string& name, const std::string& content) {
    put(folder / name, content);
    Result<Image> image = read_image(folder / name);
    REQUIRE(image.error == "");
    return std::move(image.value);
}

/// Little-endian numbers of a TIFF file.
class Tiff {
  public:
    void word(unsigned v) { number(v, 2); }
    void entry(unsigned tag, unsigned type, unsigned count, unsigned value) {
        word(tag), word(type), number(count, 4), number(value, 4);
    }
    void number(unsigned v, int bytes) {
        for (int i = 0; i < bytes; ++i) text += static_cast<char>(v >> (8 * i));
    }
    std::string text = "II*";
};

/// 32 x 20 grey bytes in four tiles of 16 x 16; the pixel (x, y) is 7 x + y.
std::string tiled_tiff() {
    Tiff t;
    t.number(0, 1);
    constexpr unsigned entries = 9, directory = 8, offsets = directory + 2 + 12 * entries + 4;
    constexpr unsigned sizes = offsets + 16, tiles = sizes + 16, tile = 256;
    t.number(directory, 4);
    t.word(entries);
    t.entry(256, 3, 1, 32), t.entry(257, 3, 1, 20);  // width, height
    t.entry(258, 3, 1, 8), t.entry(259, 3, 1, 1);    // bits, no compression
    t.entry(262, 3, 1, 1);                           // 0 is black
    t.entry(322, 3, 1, 16), t.entry(323, 3, 1, 16);  // tile width, height
    t.entry(324, 4, 4, offsets), t.entry(325, 4, 4, sizes);
    t.number(0, 4);
    for (unsigned i = 0; i < 4; ++i) t.number(tiles + i * tile, 4);
    for (unsigned i = 0; i < 4; ++i) t.number(tile, 4);
    for (unsigned i = 0; i < 4 * tile; ++i) {
        const unsigned x = i / tile % 2 * 16 + i % 16, y = i / tile / 2 * 16 + i % tile / 16;
        t.number((7 * x + y) % 256, 1);
    }
    return t.text;
}

/// An image of 40 000 pixels a side, or of one tile of that size, in a kilobyte of RGB.
std::string huge_tiff(unsigned side, bool is_tiled) {
    constexpr unsigned huge = 40000, entries = 9;
    Tiff t;
    t.number(0, 1);
    t.number(8, 4);
    t.word(entries);
    t.entry(256, 4, 1, side), t.entry(257, 4, 1, side);
    t.entry(258, 3, 1, 8), t.entry(259, 3, 1, 1), t.entry(262, 3, 1, 2);
    if (!is_tiled) t.entry(273, 4, 1, 200);
    t.entry(277, 3, 1, 3);
    if (!is_tiled) t.entry(278, 4, 1, huge), t.entry(279, 4, 1, 800);
    if (is_tiled) t.entry(322, 4, 1, huge), t.entry(323, 4, 1, huge);
    if (is_tiled) t.entry(324, 4, 1, 200), t.entry(325, 4, 1, 800);
    t.text.resize(1024);
    return t.text;
}

}  // namespace

TEST_CASE("eight-bit values stay as stored") {
    const TemporaryFolder folder;
    const Image image = read(folder, "p.ppm", "P6 2 1 255\n" + text_of({0, 1, 127, 128, 254, 255}));
    CHECK(image.channels == 3);
    CHECK(std::get<Bytes>(image.pixels) == Bytes{0, 1, 127, 128, 254, 255});
    CHECK(image.color(0, 0) == Color(0, 1 / 255.0F, 127 / 255.0F));
    CHECK(image.color(1, 0) == Color(128 / 255.0F, 254 / 255.0F, 1));
}

TEST_CASE("colours are not multiplied by alpha") {
    const TemporaryFolder folder;
    // Truevision: no palette, uncompressed, 1 x 1, 32 bits with 8 of alpha, from the top; B G R A
    const Image image =
        read(folder, "p.tga", text_of({0, 0, 2, 0, 0,  0,    0,  0,  0,   0, 0, 0,  //
                                       1, 0, 1, 0, 32, 0x28, 10, 20, 200, 64}));
    CHECK(image.channels == 4);
    CHECK(std::get<Bytes>(image.pixels) == Bytes{200, 20, 10, 64});
}

TEST_CASE("what OpenImageIO reads wrong is refused") {
    const TemporaryFolder folder;
    const Bytes webp = {'R', 'I', 'F', 'F',  24,   0,    0,    0,  'W', 'E',  'B',
                        'P', 'V', 'P', '8',  'L',  11,   0,    0,  0,   0x2f, 1,
                        64,  0,   16,  0x28, 0x4d, 0xff, 0xa3, 64, 1,   0};
    put(folder / "p.webp", text_of(webp));
    CHECK_THAT(read_image(folder / "p.webp").error,
               ContainsSubstring("a WebP with alpha is not supported"));
    put(folder / "p.pfm", "PF\r\n1 1\r\n-1.0\r\nxxxxxxxxxxxx");
    CHECK_THAT(read_image(folder / "p.pfm").error, ContainsSubstring("the PFM is damaged"));
}

TEST_CASE("a small file of a large image, or of a large tile, is refused by its header") {
    const TemporaryFolder folder;
    for (const bool is_tiled : {false, true}) {
        CAPTURE(is_tiled);
        put(folder / "huge.tif", huge_tiff(is_tiled ? 16 : 40000, is_tiled));
        CHECK_THAT(read_image(folder / "huge.tif", Extent::header).error,
                   ContainsSubstring("the TIFF is damaged, cut short"));
    }
}

TEST_CASE("an image that its reader would allocate when it opens the file is refused before") {
    const TemporaryFolder folder;
    const std::string side = "@\x9c", zero(2, '\0');  // 40 000, and the upper half of four bytes
    const std::string gif = "GIF89a" + side + side + std::string(1000, 'x');
    const std::string bmp = "BM" + std::string(16, 'x') + side + zero + side + zero + gif;
    for (const std::string& content : {gif, bmp}) {
        put(folder / "huge", content);
        const std::int64_t bytes = bytes_at_opening(content);
        CHECK(bytes == std::int64_t{4} * 40000 * 40000);
        CHECK(!may_contain((folder / "huge").c_str(), bytes));
        CHECK_THAT(read_image(folder / "huge").error, ContainsSubstring("is damaged, cut short"));
    }
    CHECK(bytes_at_opening(tiled_tiff()) == 0);
    CHECK(may_contain((folder / "huge").c_str(), 1 << 20));
}

TEST_CASE("one channel is grey") {
    const TemporaryFolder folder;
    const Image image = read(folder, "p.pgm", "P5 1 2 255\n" + text_of({51, 102}));
    CHECK(image.channels == 1);
    CHECK(image.color(0, 0) == Color(51 / 255.0F));
    CHECK(image.color(0, 1) == Color(102 / 255.0F));
}

TEST_CASE("sixteen bits become floats") {
    const TemporaryFolder folder;
    const Image image = read(folder, "p.ppm", "P6 1 1 65535\n" + text_of({0, 0, 1, 0, 255, 255}));
    CHECK(std::holds_alternative<Floats>(image.pixels));
    const Color expected(0, 256 / 65535.0F, 1);  // some versions of the reader lose the last bit
    CHECK(image.color(0, 0).equalWithAbsError(expected, 1 / 65535.0F));
}

TEST_CASE("floats beyond one are kept, rows from the top") {
    const TemporaryFolder folder;
    const Floats bottom_up = {1, 2, 3, -4, 1e20F, 0.125F};
    std::string data(sizeof(float) * bottom_up.size(), 0);
    std::memcpy(data.data(), bottom_up.data(), data.size());
    const Image image = read(folder, "p.pfm", "PF\n1 2\n-1.0\n" + data);
    CHECK(std::get<Floats>(image.pixels) == Floats{-4, 1e20F, 0.125F, 1, 2, 3});
}

TEST_CASE("an image without pixels is none, and that is said") {
    const TemporaryFolder folder;
    put(folder / "p.pfm", "Pf2\n0\n 5\n");
    for (const Extent extent : {Extent::header, Extent::whole}) {
        const std::string error = read_image(folder / "p.pfm", extent).error;
        // Some versions of the reader do not take it for an image at all.
        const bool is_said =
            error.ends_with("it has no pixels") ||
            error.ends_with("it is not an image; expected EXR, PNG, JPEG, HDR or PFM");
        INFO(error);
        CHECK(is_said);
    }
}

TEST_CASE("a Radiance image is linear floats") {
    const TemporaryFolder folder;
    const Image image =
        read(folder, "p.hdr",
             "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" + text_of({128, 64, 32, 130}));
    const Color c = image.color(0, 0);  // mantissa / 256 * 2^(exponent - 128), or half a step more
    CHECK(c.x == Approx(2).epsilon(0.01));
    CHECK(c.y == Approx(1).epsilon(0.01));
    CHECK(c.z == Approx(0.5).epsilon(0.02));
}

TEST_CASE("a Radiance image is upright, whatever the order of its pixels") {
    const TemporaryFolder folder;
    const auto letter = [](int x, int y) {  // of a picture of 3 x 2 pixels
        return static_cast<char>(130 + 10 * x + 50 * y);
    };
    const std::pair<const char*, const char*> axes[] = {{"-Y 2", "+X 3"}, {"-Y 2", "-X 3"},
                                                        {"+Y 2", "-X 3"}, {"+Y 2", "+X 3"},
                                                        {"+X 3", "-Y 2"}, {"-X 3", "+Y 2"}};
    for (const auto& [outer, inner] : axes) {
        CAPTURE(outer, inner);
        std::string text =
            std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n") + outer + " " + inner + "\n";
        for (int i = 0; i < outer[3] - '0'; ++i) {
            for (int k = 0; k < inner[3] - '0'; ++k) {
                const auto along = [](const char* axis, int number) {
                    return (axis[0] == '+') == (axis[1] == 'X') ? number : axis[3] - '1' - number;
                };
                const bool by_rows = outer[1] == 'Y';
                const int x = by_rows ? along(inner, k) : along(outer, i);
                const int y = by_rows ? along(outer, i) : along(inner, k);
                text += std::string(3, letter(x, y)) + '\x88';
            }
        }
        const Image image = read(folder, "p.hdr", text);
        REQUIRE(image.width == 3);
        REQUIRE(image.height == 2);
        for (int y = 0; y < 2; ++y) {
            for (int x = 0; x < 3; ++x) {
                CHECK(image.color(x, y).x ==
                      Approx(static_cast<unsigned char>(letter(x, y))).margin(1));
            }
        }
        CHECK(read_image(folder / "p.hdr", Extent::header).value.width == 3);
    }
    for (const std::string other : {"+X 3 +Y 2", "-X 3 -Y 2"}) {
        put(folder / "p.hdr",
            "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + other + "\n" + std::string(24, '\x80'));
        CHECK(read_image(folder / "p.hdr").error.ends_with("not supported; expected -Y +X"));
    }
}

TEST_CASE("a TIFF is upright, whatever its orientation") {
    const TemporaryFolder folder;
    // Seen, all are the rows ab, cd, ef.
    const std::pair<int, const char*> stored[] = {{1, "abcdef"}, {2, "badcfe"}, {3, "fedcba"},
                                                  {4, "efcdab"}, {5, "acebdf"}, {6, "bdface"},
                                                  {7, "fdbeca"}, {8, "ecafdb"}};
    for (const auto& [orientation, pixels] : stored) {
        CAPTURE(orientation);
        const bool is_transposed = orientation > 4;
        Tiff t;
        t.number(0, 1);
        t.number(8, 4);
        t.word(9);
        t.entry(256, 3, 1, is_transposed ? 3 : 2), t.entry(257, 3, 1, is_transposed ? 2 : 3);
        t.entry(258, 3, 1, 8), t.entry(259, 3, 1, 1), t.entry(262, 3, 1, 1);
        t.entry(273, 4, 1, 8 + 2 + 12 * 9 + 4);  // offset of the pixels
        t.entry(274, 3, 1, static_cast<unsigned>(orientation));
        t.entry(278, 3, 1, 3), t.entry(279, 4, 1, 6);  // rows and bytes of the strip
        t.number(0, 4);
        const Image image = read(folder, "o.tif", t.text + pixels);
        CHECK(image.width == 2);
        CHECK(image.height == 3);
        CHECK(text_of(std::get<Bytes>(image.pixels)) == "abcdef");
    }
}

TEST_CASE("a TIFF that has a place on a page is read from its own first row and column") {
    const TemporaryFolder folder;
    constexpr unsigned entries = 12, fractions = 8 + 2 + 12 * entries + 4;
    Tiff t;
    t.number(0, 1);
    t.number(8, 4);
    t.word(entries);
    t.entry(256, 3, 1, 2), t.entry(257, 3, 1, 3);
    t.entry(258, 3, 1, 8), t.entry(259, 3, 1, 1), t.entry(262, 3, 1, 1);
    t.entry(273, 4, 1, fractions + 24);                            // offset of the pixels
    t.entry(278, 3, 1, 3), t.entry(279, 4, 1, 6);                  // rows and bytes of the strip
    t.entry(282, 5, 1, fractions), t.entry(283, 5, 1, fractions);  // pixels in a unit of length
    t.entry(286, 5, 1, fractions + 8), t.entry(287, 5, 1, fractions + 16);  // place: x, y
    t.number(0, 4);
    for (const unsigned number : {1, 5, 2}) t.number(number, 4), t.number(1, 4);
    const Image image = read(folder, "p.tif", t.text + "abcdef");
    CHECK(image.width == 2);
    CHECK(image.height == 3);
    CHECK(text_of(std::get<Bytes>(image.pixels)) == "abcdef");
}

TEST_CASE("tiles are put in their places, cut at the edge") {
    const TemporaryFolder folder;
    const Image image = read(folder, "p.tif", tiled_tiff());
    REQUIRE(image.width == 32);
    REQUIRE(image.height == 20);
    const Bytes& bytes = std::get<Bytes>(image.pixels);
    REQUIRE(bytes.size() == 32 * 20);
    int wrong = 0;
    for (int i = 0; i < 32 * 20; ++i) wrong += bytes[i] != (7 * (i % 32) + i / 32) % 256;
    CHECK(wrong == 0);
}

TEST_CASE("a file's reader is chosen by its first bytes, or else by its name") {
    const TemporaryFolder folder;
    CHECK(read(folder, "tiff.hdr", tiled_tiff()).width == 32);
    const std::string grey = std::string("P5 2 1 255\n") + "ab";
    CHECK(read(folder, "grey.pgm", grey).width == 2);
    put(folder / "grey.hdr", grey);
    CHECK(read_image(folder / "grey.hdr").error != "");
}
