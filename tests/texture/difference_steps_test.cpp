#include "core/texture/difference_steps.h"

#include "core/image/io.h"
#include "core/texture/texture_values.h"
#include "tests/catch.h"
#include "tests/temporary_folder.h"

using namespace etalon;

namespace {

/// Returns the steps of the last texture of numbers.
DifferenceSteps steps_of(const Textures& textures) {
    std::vector<std::string> problems;
    const TextureValues values(textures, problems);
    REQUIRE(problems.empty());
    const auto last = static_cast<std::uint32_t>(textures.numbers.size() - 1);
    return values.difference_steps({0, last});
}

Affine scaled(double factor) {
    return {{factor, 0, 0}, {0, factor, 0}, {0, 0, factor}, {}};
}

}  // namespace

TEST_CASE("Difference steps: given an image, then they are a fraction of its texels", "[texture]") {
    const test::TemporaryFolder folder;
    RenderedImage image{};
    image.width = 8, image.height = 2;
    image.window = {{0, 0}, {7, 1}};
    image.pixels.resize(16, Color(0.5F));
    const std::string file = folder / "heights.exr";
    REQUIRE(write_image(file, image).empty());

    const auto steps = [&](const Mapping& mapping) {
        return steps_of({{ImageTexture<float>{mapping, 0}}, {}, {{file}}});
    };
    CHECK(steps(UvMapping{}).uv == 1 / 32.0);
    CHECK(steps(UvMapping{100, 1, 0, 0}).uv == 1 / 3200.0);
    CHECK(steps(UvMapping{1, -100, 0, 0}).uv == 1 / 800.0);
    CHECK(steps(UvMapping{}).space == infinity);
    CHECK(steps(PlanarMapping{{0, 0, 10}, {0, 1, 0}, 0, 0}).space == 1 / 320.0);
    CHECK(steps(PlanarMapping{}).uv == infinity);
}

TEST_CASE("Difference steps: given noise, then they are a fraction of its finest cells",
          "[texture]") {
    const auto steps = [](double scale, int octaves) {
        return steps_of({{FbmTexture{scaled(scale), {octaves, 0.5F}}}, {}, {}}).space;
    };
    CHECK(steps(1, 1) == 1 / 16.0);
    CHECK(steps(8, 1) == 1 / 128.0);
    CHECK(std::abs(steps(1, 2) - 1 / (16 * 1.99)) < 1e-12);
    CHECK(steps(1, 30) == steps(1, 10));
    CHECK(steps(1, -3) == steps(1, 1));
}

TEST_CASE("Difference steps: given a texture of textures, then they are the least", "[texture]") {
    const FbmTexture coarse{scaled(1), {1, 0.5F}}, fine{scaled(4), {1, 0.5F}};
    const Textures mixed{{coarse, fine, MixTexture<float>{{0, 0}, {1}, {0, 1}}}, {}, {}};
    CHECK(steps_of(mixed).space == 1 / 64.0);
    CHECK(steps_of({{ScaleTexture<float>{{1}, {2}}}, {}, {}}).space == infinity);
}
