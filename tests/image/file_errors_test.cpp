#include <sys/stat.h>
#include <zlib.h>

#include <cstdlib>

#include "core/image/io.h"
#include "core/numerics/random.h"
#include "tests/catch.h"
#include "tests/formats/shared_scenes.h"
#include "tests/image/encoded_files.h"
#include "tests/image/random_images.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

/// Requires a message of one line that names the file and gives a reason.
void check_unreadable(const std::string& path) {
    const Result<Image> read = read_image(path);
    INFO(read.error);
    CHECK_THAT(read.error, StartsWith(path + ": cannot be read: "));
    CHECK(read.error.size() > path.size() + 25);
    CHECK(read.error.find('\n') == std::string::npos);
    CHECK(read.value.empty());
}

/// Reads a file, which may fail; an image that is read must be complete.
void check_sane(const std::string& path) {
    const Result<Image> read = read_image(path);
    if (!read) return;
    const std::size_t size =
        std::visit([](const auto& values) { return values.size(); }, read.value.pixels);
    const Image& image = read.value;
    CHECK(size == std::size_t(image.width) * image.height * image.channels);
}

/// The check of a PNG chunk's name and content, the higher bytes first.
std::string checksum(const std::string& chunk) {
    const auto* bytes = reinterpret_cast<const Bytef*>(chunk.data());
    const uLong sum = crc32(0, bytes, static_cast<uInt>(chunk.size()));
    std::string text;
    for (int k = 24; k >= 0; k -= 8) text += static_cast<char>(sum >> k);
    return text;
}

}  // namespace

TEST_CASE("an unreadable file is named with the reason") {
    const TemporaryFolder folder;
    for (const std::string kind : {".exr", ".png", ".jpg", ".hdr", ".tif", ".unknown", ""}) {
        CHECK(read_image(folder / ("none" + kind)).error ==
              (folder / ("none" + kind)) + ": cannot be read: No such file or directory");
        put(folder / ("text" + kind), "This is no picture.\n");
        check_unreadable(folder / ("text" + kind));
        put(folder / ("empty" + kind), "");
        check_unreadable(folder / ("empty" + kind));
        std::filesystem::create_directory(folder / ("folder" + kind));
        CHECK_THAT(read_image(folder / ("folder" + kind)).error,
                   ContainsSubstring("Is a directory"));
    }
}

TEST_CASE("a pipe is refused as such") {
    const TemporaryFolder folder;
    REQUIRE(::mkfifo((folder / "pipe.png").c_str(), 0600) == 0);
    CHECK_THAT(read_image(folder / "pipe.png").error,
               EndsWith("a pipe or device; expected a file"));
}

TEST_CASE("garbage after a true beginning is refused") {
    const TemporaryFolder folder;
    std::string garbage(5000, 0);
    Random random(7);
    for (char& c : garbage) c = static_cast<char>(random.bits());
    put(folder / "g.jpg", "\xff\xd8\xff\xe0" + garbage);
    check_unreadable(folder / "g.jpg");
    put(folder / "g.png", "\x89PNG\r\n\x1a\n" + garbage);
    check_unreadable(folder / "g.png");
    put(folder / "g.exr", "\x76\x2f\x31\x01" + garbage);
    check_unreadable(folder / "g.exr");
}

TEST_CASE("a file that ends early is refused") {
    const TemporaryFolder folder;
    put(folder / "whole.ppm", std::string("P6 40 40 255\n").append(3 * 40 * 40, 'x'));
    REQUIRE(read_image(folder / "whole.ppm").error == "");
    REQUIRE(write_image(folder / "whole.exr", random_image(40, 40)) == "");
    REQUIRE(write_image(folder / "whole.png", random_image(40, 40)) == "");
    put(folder / "whole.jpg", encoded_jpeg({}, 40, 40));
    for (const std::string kind : {".exr", ".jpg", ".png", ".ppm"}) {
        const std::string whole = content_of(folder / ("whole" + kind));
        for (const int percent : {1, 20, 50, 90, 99}) {
            put(folder / ("cut" + kind), whole.substr(0, whole.size() * percent / 100));
            check_unreadable(folder / ("cut" + kind));
        }
    }
}

TEST_CASE("a file that claims more than it holds, or more than is read, is refused") {
    const TemporaryFolder folder;
    std::string png = encoded_png({}, 1, 1);
    const auto claim = [&](std::uint32_t width, std::uint32_t height) {
        std::string header = "IHDR";
        for (const std::uint32_t side : {width, height}) {
            for (int k = 24; k >= 0; k -= 8) header += static_cast<char>(side >> k);
        }
        header += png.substr(24, 5);
        const std::string check = checksum(header);
        put(folder / "p.png", png.substr(0, 12) + header + check + png.substr(33));
        check_unreadable(folder / "p.png");
    };
    claim(0, 1);
    claim(65537, 1);
    claim(1, 65537);
    claim(65536, 65536);
    claim(0x7fffffff, 0x7fffffff);
    claim(0xffffffff, 1);

    for (const bool progressive : {false, true}) {
        JpegKind kind;
        kind.progressive = progressive;
        std::string jpeg = encoded_jpeg(kind, 8, 8);
        const std::size_t frame = jpeg.find(progressive ? "\xff\xc2" : "\xff\xc0");
        jpeg.replace(frame + 5, 4, "\xff\xdc\xff\xdc");  // 65500 x 65500, the most there is
        put(folder / "p.jpg", jpeg);
        check_unreadable(folder / "p.jpg");
        jpeg.replace(frame + 5, 4, "\xff\xff\xff\xff");
        put(folder / "p.jpg", jpeg);
        check_unreadable(folder / "p.jpg");
    }
}

TEST_CASE("a progressive JPEG whose first scan is missing, or of hundreds of scans, is refused") {
    const TemporaryFolder folder;
    JpegKind kind;
    kind.progressive = true;
    const std::string jpeg = encoded_jpeg(kind, 64, 64);
    const std::string scan = "\xff\xda", tables = "\xff\xc4";
    const std::size_t first = jpeg.find(scan), second = jpeg.find(tables, first),
                      third = jpeg.find(tables, jpeg.find(scan, second));
    put(folder / "p.jpg", jpeg.substr(0, first) + jpeg.substr(second));
    check_unreadable(folder / "p.jpg");

    for (const auto& [scans, is_read] : {std::pair(50, true), std::pair(600, false)}) {
        std::string many = jpeg.substr(0, second);
        for (int i = 0; i < scans; ++i) many += jpeg.substr(second, third - second);
        put(folder / "p.jpg", many + jpeg.substr(third));
        CHECK(static_cast<bool>(read_image(folder / "p.jpg")) == is_read);
    }
}

TEST_CASE("an EXR with flipped bytes is a image or an error") {
    const TemporaryFolder folder;
    RenderedImage rendered = random_image(40, 40);
    rendered.metadata = {{"software", std::string("Etalon")}};
    REQUIRE(write_image(folder / "whole.exr", rendered) == "");
    const std::string whole = content_of(folder / "whole.exr");
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        std::string damaged = whole;
        const std::size_t range = i % 2 == 0 ? damaged.size() : 400;  // the header half of the time
        damaged[random.index(range)] = static_cast<char>(random.bits());
        put(folder / "damaged.exr", damaged);
        check_sane(folder / "damaged.exr");
    }
}

TEST_CASE("an image that cannot be written is reported with the reason and leaves no file") {
    const TemporaryFolder folder;
    for (const std::string kind : {".exr", ".png"}) {
        const RenderedImage rendered = random_image(4, 3);
        CHECK_THAT(write_image(folder / ("none/p" + kind), rendered),
                   StartsWith(folder / ("none/p" + kind)) &&
                       ContainsSubstring("No such file or directory"));
        std::filesystem::create_directory(folder / ("folder" + kind));
        CHECK_THAT(write_image(folder / ("folder" + kind), rendered),
                   ContainsSubstring("Is a directory"));
        std::filesystem::remove(folder / ("folder" + kind));
        std::filesystem::create_symlink("/dev/full", folder / ("full" + kind));
        CHECK_THAT(write_image(folder / ("full" + kind), rendered),
                   ContainsSubstring("No space left"));
        std::filesystem::remove(folder / ("full" + kind));
    }
    CHECK(folder.names().empty());
}

TEST_CASE("only .exr and .png are written") {
    const TemporaryFolder folder;
    CHECK(can_write("a/b.exr"));
    CHECK(can_write("B.Png"));
    for (const char* name : {"p.jpg", "p", "exr", ".exr", "p.exr.gz"}) {
        CHECK_FALSE(can_write(name));
        CHECK_THAT(write_image(folder / name, random_image(1, 1)),
                   ContainsSubstring(".exr or .png"));
    }
    CHECK(folder.names().empty());
}

TEST_CASE("an image whose pixels do not fill its window is an error") {
    const TemporaryFolder folder;
    RenderedImage rendered = random_image(4, 3);
    SECTION("too few") {
        rendered.pixels.pop_back();
    }
    SECTION("too many") {
        rendered.pixels.emplace_back();
    }
    SECTION("no window") {
        rendered.window.makeEmpty();
    }
    SECTION("no frame") {
        rendered.width = 0;
    }
    for (const char* name : {"p.exr", "p.png"}) {
        CHECK_THAT(write_image(folder / name, rendered), ContainsSubstring("do not agree"));
    }
    CHECK(folder.names().empty());
}

TEST_CASE("a large JPEG is bytes, and refused if it ends early", "[needs_shared_scenes]") {
    const std::string skybox = shared_scenes_folder() / "p3f/skybox/top.jpg";
    SKIP_UNLESS(std::filesystem::exists(skybox), skybox << " does not exist");
    const Result<Image> read = read_image(skybox);
    REQUIRE(read.error == "");
    CHECK(read.value.width == 2048);
    CHECK(read.value.height == 2048);
    CHECK(std::holds_alternative<PixelBytes>(read.value.pixels));

    const TemporaryFolder folder;
    const std::string whole = content_of(skybox);
    put(folder / "cut.jpg", std::string_view(whole).substr(0, whole.size() / 2));
    check_unreadable(folder / "cut.jpg");
}
