#include "core/image/encode.h"
#include "core/image/io.h"
#include "tests/catch.h"
#include "tests/image/pictures.h"
#include "tests/image/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

const std::vector<std::uint8_t>& bytes_of(const Image& image) {
    return std::get<std::vector<std::uint8_t>>(image.pixels);
}

/// The data of a PNG file's first chunk of a kind; "" if there is none, which for kinds that have
/// data is told apart.
std::string chunk(const std::string& file, const std::string& kind) {
    const std::size_t at = file.find(kind);
    if (at == std::string::npos) return {};
    const auto size = static_cast<std::uint8_t>(file[at - 1]);
    return file.substr(at + 4, size);
}

}  // namespace

TEST_CASE("a PNG read back has the bytes the encoding says, whatever the values") {
    const TemporaryFolder folder;
    Picture picture = random_picture(67, 41);
    picture.display_colors = GENERATE(false, true);
    for (std::size_t i = 0; i < 1000; ++i) {  // ordinary values beside the wild ones
        picture.pixels[i] = Color(static_cast<float>(i) / 1000, 0.5F, 0.18F);
    }
    REQUIRE(write_picture(folder / "p.PNG", picture, 0.5) == "");
    const Outcome<Image> read = read_image(folder / "p.PNG");
    REQUIRE(read.error == "");
    CHECK(read.value.width == 67);
    CHECK(read.value.height == 41);
    CHECK(read.value.channels == 3);
    CHECK(bytes_of(read.value) == display_bytes(picture, 0.5));
    CHECK(folder.names() == std::vector<std::string>{"p.PNG"});
}

TEST_CASE("a PNG says that it is sRGB") {
    const TemporaryFolder folder;
    REQUIRE(write_picture(folder / "p.png", random_picture(4, 3)) == "");
    const std::string file = content_of(folder / "p.png");
    CHECK(file.substr(1, 3) == "PNG");
    CHECK(chunk(file, "sRGB").size() == 1);
}

TEST_CASE("a crop's PNG holds the crop and says where it belongs") {
    const TemporaryFolder folder;
    const Picture picture = random_picture(10, 8, {{3, 2}, {8, 5}});
    REQUIRE(write_picture(folder / "p.png", picture) == "");
    const Outcome<Image> read = read_image(folder / "p.png");
    REQUIRE(read.error == "");
    CHECK(read.value.width == 6);
    CHECK(read.value.height == 4);
    CHECK(bytes_of(read.value) == display_bytes(picture, 0));
    CHECK(chunk(content_of(folder / "p.png"), "oFFs") == std::string("\0\0\0\3\0\0\0\2\0", 9));
}
