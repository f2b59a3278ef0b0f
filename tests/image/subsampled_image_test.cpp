// JPEG files read with their chroma as it is stored have the colours that libjpeg gives.
#include <string>

#include "core/image/bilinear.h"
#include "core/image/io.h"
#include "core/numerics/random.h"
#include "tests/catch.h"
#include "tests/image/encoded_files.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

JpegKind kind_named(const std::string& name) {
    for (const JpegKind& kind : jpeg_kinds()) {
        if (kind.name == name) return kind;
    }
    FAIL("no such kind");
    return {};
}

bool is_subsampled(const CompactImage& image) {
    return std::holds_alternative<SubsampledImage>(image);
}

/// Returns how many pixels of two images differ. The images must have the same size.
template <class AnyImage>
int differing_pixels(const Image& a, const AnyImage& b) {
    REQUIRE(a.width == b.width);
    REQUIRE(a.height == b.height);
    REQUIRE(a.encoding == b.encoding);
    int count = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) count += a.color(x, y) != b.color(x, y);
    }
    return count;
}

/// Reads a file in both forms, which must agree. Returns whether chroma is subsampled.
bool check_file(const TemporaryFolder& folder, const std::string& content) {
    const std::string path = folder / "p.jpg";
    put(path, content);
    const Result<Image> whole = read_image(path);
    const Result<CompactImage> compact = read_compact_image(path);
    CHECK(whole.error == compact.error);
    if (!whole || !compact) return false;
    CHECK(std::visit([&](const auto& image) { return differing_pixels(whole.value, image); },
                     compact.value) == 0);
    return is_subsampled(compact.value);
}

/// Returns points in all parts of an image, some on its edges and at centres of pixels.
BilinearPoints random_points(const Image& image, Random& random) {
    BilinearPoints points;
    const auto place = [&](int size) {
        const std::size_t way = random.index(4);
        if (way == 0) return static_cast<double>(random.index(2));
        if (way == 1) return (static_cast<double>(random.index(size)) + 0.5) / size;
        return random.uniform();
    };
    const std::size_t count = 1 + random.index(BilinearPoints::most);
    while (points.count < count)
        points.add(image.width, image.height, place(image.width), place(image.height));
    return points;
}

void check_interpolated(const Image& image, const SubsampledImage& subsampled, Random& random) {
    for (int i = 0; i < 20; ++i) {
        const BilinearPoints points = random_points(image, random);
        BilinearColors expected, found;
        interpolate(image, points, expected);
        interpolate(subsampled, points, found);
        for (std::size_t k = 0; k < points.count; ++k) {
            CAPTURE(image.width, image.height, points.x[k], points.y[k], points.fx[k],
                    points.fy[k]);
            REQUIRE(found[k] == expected[k]);
        }
    }
}

}  // namespace

TEST_CASE("a JPEG of any kind has the same pixels in compact form") {
    const TemporaryFolder folder;
    for (const JpegKind& kind : jpeg_kinds()) {
        INFO(kind.name);
        const bool subsamples = kind.stored == JCS_YCbCr && kind.sampling == 2;
        CHECK(check_file(folder, encoded_jpeg(kind, 67, 131)) == subsamples);
        CHECK(check_file(folder, encoded_jpeg(kind, 160, 32)) == subsamples);
    }
}

TEST_CASE("a JPEG of any size has the same pixels in compact form") {
    const TemporaryFolder folder;
    const JpegKind kind = kind_named("halved colours");
    for (int width = 1; width <= 35; ++width) {
        for (const int height : {1, 2, 3, 7, 8, 9, 15, 16, 17, 18, 33}) {
            CAPTURE(width, height);
            // What libjpeg does not interpolate is read as RGB.
            CHECK(check_file(folder, encoded_jpeg(kind, width, height)) == (width > 4));
        }
    }
}

TEST_CASE("a damaged JPEG is the same image in compact form, or the same error") {
    const TemporaryFolder folder;
    Random random(11);
    for (const char* name : {"halved colours", "progressive", "restarts"}) {
        const std::string content = encoded_jpeg(kind_named(name), 75, 150);
        int subsampled = 0;
        for (int i = 0; i < 60; ++i) {
            CAPTURE(name, i);
            std::string file = content;
            file[2 + random.index(file.size() - 2)] = static_cast<char>(random.bits());
            if (i % 4 == 0) file.resize(1 + random.index(file.size()));
            subsampled += check_file(folder, file);
        }
        CHECK(subsampled > 10);
    }
}

TEST_CASE("a subsampled image takes half the bytes of RGB") {
    const TemporaryFolder folder;
    put(folder / "p.jpg", encoded_jpeg(kind_named("halved colours"), 64, 48));
    const Result<CompactImage> image = read_compact_image(folder / "p.jpg");
    REQUIRE(is_subsampled(image.value));
    CHECK(std::get<SubsampledImage>(image.value).pairs.size() == 64 * 48 * 3 / 2);
}

TEST_CASE("a subsampled image is interpolated as its pixels are") {
    const TemporaryFolder folder;
    const JpegKind kind = kind_named("halved colours");
    const std::string path = folder / "p.jpg";
    Random random(12);
    for (const auto& [width, height] :
         {std::pair(5, 1), {6, 2}, {8, 3}, {17, 16}, {32, 31}, {99, 67}, {128, 64}}) {
        put(path, encoded_jpeg(kind, width, height));
        const Result<CompactImage> subsampled = read_compact_image(path);
        REQUIRE(is_subsampled(subsampled.value));
        check_interpolated(read_image(path).value, std::get<SubsampledImage>(subsampled.value),
                           random);
    }
}

TEST_CASE("a file in another format has the same pixels in compact form") {
    const TemporaryFolder folder;
    put(folder / "p.png", encoded_png({}, 35, 21));
    const Result<CompactImage> image = read_compact_image(folder / "p.png");
    REQUIRE(std::holds_alternative<Image>(image.value));
    CHECK(differing_pixels(read_image(folder / "p.png").value, std::get<Image>(image.value)) == 0);
    CHECK_THAT(read_compact_image(folder / "q.jpg").error,
               Catch::Matchers::StartsWith((folder / "q.jpg") + ": cannot be read: "));
}
