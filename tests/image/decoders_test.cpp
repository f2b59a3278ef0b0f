// The readers of JPEG and PNG give the same pixels as OpenImageIO.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/image/io.h"
#include "core/image/oiio.h"
#include "core/numerics/random.h"
#include "tests/catch.h"
#include "tests/image/encoded_files.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

/// Some versions of OpenImageIO lose the last bit of a 16-bit value.
bool same_values(float a, float b) {
    return std::abs(a - b) <= 0x1p-24F;
}
bool same_values(std::uint8_t a, std::uint8_t b) {
    return a == b;
}

template <class Pixels>
bool same_pixels(const Pixels& a, const Pixels& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](auto x, auto y) { return same_values(x, y); });
}

bool same(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && a.channels == b.channels &&
           a.encoding == b.encoding && a.origin == b.origin &&
           a.pixels.index() == b.pixels.index() &&
           std::visit(
               [&](const auto& values) {
                   return same_pixels(values, std::get<std::decay_t<decltype(values)>>(b.pixels));
               },
               a.pixels);
}

void check_as_openimageio(const TemporaryFolder& folder, const std::string& name,
                          const std::string& content) {
    put(folder / name, content);
    const Result<Image> ours = read_image(folder / name);
    const Result<Image> theirs = read_oiio(folder / name, Extent::whole);
    REQUIRE(theirs.error == "");
    REQUIRE(ours.error == "");
    CHECK(same(ours.value, theirs.value));

    const Result<Image> header = read_image(folder / name, Extent::header);
    CHECK(header.error == "");
    CHECK(header.value.width == ours.value.width);
    CHECK(header.value.channels == ours.value.channels);
    CHECK(std::visit([](const auto& values) { return values.empty(); }, header.value.pixels));
}

/// Returns `content` truncated, or with some bytes replaced.
std::string damaged(const std::string& content, Random& random) {
    std::string file = content;
    if (random.index(4) == 0) return file.substr(0, random.index(file.size()));
    const std::size_t range =
        random.index(2) == 0 ? file.size() : std::min<std::size_t>(file.size(), 200);
    for (std::size_t i = random.index(3); i < 3; ++i) {
        file[2 + random.index(range - 2)] = static_cast<char>(random.bits());
    }
    return file;
}

/// Files that both can read give the same image. One may reject files that the other accepts:
/// OpenImageIO accepts a JPEG with a scan that ends early, and checks only the first of several
/// warnings.
void check_damaged(const TemporaryFolder& folder, const std::string& name,
                   const std::string& content) {
    constexpr int count = 24;
    Random random(5);
    int refused_by_one = 0;
    for (int i = 0; i < count; ++i) {
        INFO(i);
        put(folder / name, damaged(content, random));
        const Result<Image> ours = read_image(folder / name);
        const Result<Image> theirs = read_oiio(folder / name, Extent::whole);
        if (ours && theirs) CHECK(same(ours.value, theirs.value));
        refused_by_one += ours.error.empty() != theirs.error.empty();
        CHECK(ours.error.find('\n') == std::string::npos);
    }
    CHECK(refused_by_one <= count / 10);
}

}  // namespace

TEST_CASE("a JPEG of any kind has the pixels that OpenImageIO reads") {
    const TemporaryFolder folder;
    for (const JpegKind& kind : jpeg_kinds()) {
        INFO(kind.name);
        check_as_openimageio(folder, "p.jpg", encoded_jpeg(kind, 1, 1));
        check_as_openimageio(folder, "p.jpg", encoded_jpeg(kind, 67, 131));
    }
}

TEST_CASE("a PNG of any kind has the pixels that OpenImageIO reads") {
    const TemporaryFolder folder;
    for (const PngKind& kind : png_kinds()) {
        INFO(kind.name());
        check_as_openimageio(folder, "p.png", encoded_png(kind, 1, 1));
        check_as_openimageio(folder, "p.png", encoded_png(kind, 35, 141));
    }
}

TEST_CASE("every 16-bit value of a PNG is the float that OpenImageIO makes of it") {
    const TemporaryFolder folder;
    check_as_openimageio(folder, "p.png",
                         encoded_png({PNG_COLOR_TYPE_GRAY, 16, false, false, 0}, 1024, 1024));
}

TEST_CASE("a damaged JPEG or PNG is the image that OpenImageIO reads, or an error") {
    const TemporaryFolder folder;
    for (const JpegKind& kind : jpeg_kinds()) {
        INFO(kind.name);
        check_damaged(folder, "p.jpg", encoded_jpeg(kind, 40, 40));
    }
    for (const PngKind& kind : png_kinds()) {
        if (kind.gamma != 0) continue;
        INFO(kind.name());
        check_damaged(folder, "p.png", encoded_png(kind, 20, 20));
    }
}

TEST_CASE("JPEG and PNG are detected by their first bytes") {
    const TemporaryFolder folder;
    const std::string jpeg = encoded_jpeg(jpeg_kinds()[1], 9, 7), png = encoded_png({}, 9, 7);
    put(folder / "p.jpg", jpeg);
    put(folder / "p.png", png);
    for (const char* name : {"q.png", "q.jpg", "q.hdr", "q.unknown", "q"}) {
        put(folder / name, jpeg);
        CHECK(same(read_image(folder / name).value, read_image(folder / "p.jpg").value));
        put(folder / name, png);
        CHECK(same(read_image(folder / name).value, read_image(folder / "p.png").value));
    }
}
