// Channels of an image other than colours.
#include "core/image/io.h"
#include "tests/catch.h"
#include "tests/exr_channels.h"
#include "tests/image/random_images.h"
#include "tests/temporary_folder.h"

using namespace etalon;
using namespace etalon::test;

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

const std::vector<float> depths = {1.5F, infinite, -0.0F, 1e-40F, 3e38F, 0.1F};
const std::vector<std::uint32_t> ids = {0, 4294967295U, 16777217, 1, 2, 3};

RenderedImage with_channels() {
    RenderedImage rendered = random_image(10, 8, {{3, 2}, {5, 3}});
    rendered.channels = {{"Z", depths}, {"primitiveId", ids}, {"N.X", depths}};
    return rendered;
}

}  // namespace

TEST_CASE("channels are written with their names, types and values") {
    const TemporaryFolder folder;
    const std::string path = folder / "p.exr";
    REQUIRE(write_image(path, with_channels()) == "");
    const std::map<std::string, Imf::PixelType> expected = {
        {"R", Imf::FLOAT}, {"G", Imf::FLOAT},   {"B", Imf::FLOAT},
        {"Z", Imf::FLOAT}, {"N.X", Imf::FLOAT}, {"primitiveId", Imf::UINT}};
    CHECK(channel_types(path) == expected);
    CHECK(channel<float>(path, "Z") == depths);
    CHECK(channel<float>(path, "N.X") == depths);
    CHECK(channel<unsigned>(path, "primitiveId") == ids);
}

TEST_CASE("channels change nothing about the colours") {
    const TemporaryFolder folder;
    RenderedImage rendered = with_channels();
    REQUIRE(write_image(folder / "with.exr", rendered) == "");
    REQUIRE(write_image(folder / "with.png", rendered) == "");
    rendered.channels.clear();
    REQUIRE(write_image(folder / "without.exr", rendered) == "");
    REQUIRE(write_image(folder / "without.png", rendered) == "");
    const auto pixels = [&](const char* name) {
        const auto image = read_image(folder / name);
        REQUIRE(image.error == "");
        CHECK(image.value.channels == 3);
        return std::get<std::vector<float>>(image.value.pixels);
    };
    const auto with = pixels("with.exr"), without = pixels("without.exr");
    REQUIRE(with.size() == without.size());
    CHECK(std::memcmp(with.data(), without.data(), 4 * with.size()) == 0);
    CHECK(content_of(folder / "with.png") == content_of(folder / "without.png"));
}

TEST_CASE("a channel that has not a value for each pixel is refused, not written") {
    const TemporaryFolder folder;
    RenderedImage rendered = with_channels();
    rendered.channels.push_back({"short", std::vector<float>(5)});
    CHECK_THAT(write_image(folder / "p.exr", rendered), ContainsSubstring("p.exr"));
    CHECK(folder.names().empty());
}
