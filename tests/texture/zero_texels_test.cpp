#include "core/numerics/random.h"
#include "core/texture/texels.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

Image any_image(Random& random, bool bytes) {
    const int width = 1 << random.index(5), height = 1 << random.index(5);
    const std::size_t count = static_cast<std::size_t>(width) * height;
    Image image{width, height, 1, {}, {}, {}};
    const bool is_sparse = random.one_in(2);
    const auto is_zero = [&] { return is_sparse ? random.one_in(8) : !random.one_in(8); };
    if (bytes) {
        auto& values = image.pixels.emplace<0>(count);
        for (auto& v : values) v = is_zero() ? 0 : static_cast<std::uint8_t>(random.index(256));
    } else {
        auto& values = image.pixels.emplace<1>(count);
        for (auto& v : values) v = is_zero() ? 0.0F : static_cast<float>(random.uniform(0.01, 2));
    }
    return image;
}

}  // namespace

TEST_CASE("A bit for each texel tells where an image is 0", "[cut_outs]") {
    std::size_t zeros_found = 0, asked = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        Random random(5, seed);
        const auto image = std::make_shared<const Image>(any_image(random, seed % 2 == 0));
        const TextureImage how{"", static_cast<Wrap>(random.index(3)), random.one_in(2),
                               random.one_in(2) ? 1.0F : 0.3F};
        const Texels texels(image, how);
        const auto zeros = texels.zeros();
        REQUIRE(zeros);
        for (int i = 0; i < 200; ++i) {
            Vec2 st(random.uniform(-2, 3), random.uniform(-2, 3));
            if (random.one_in(3)) {  // centres of texels, where weights are 0
                st.x = (std::floor(st.x * image->width) + 0.5) / image->width;
                st.y = (std::floor(st.y * image->height) + 0.5) / image->height;
            }
            const bool is_zero = texels.number(st) == 0;
            REQUIRE(zeros->is_zero(st) == is_zero);
            zeros_found += is_zero ? 1 : 0;
            ++asked;
        }
        CHECK(zeros->memory_bytes() <=
              static_cast<std::size_t>(image->width) * image->height / 8 + 8);
    }
    CHECK(zeros_found > asked / 10);
    CHECK(zeros_found < asked * 9 / 10);
}

TEST_CASE("Bits do not tell where numbers of two signs, or tiny ones, add up to 0", "[cut_outs]") {
    for (const float odd : {-0.5F, 1e-30F, std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::quiet_NaN()}) {
        const auto image =
            std::make_shared<const Image>(Image{2, 1, 1, std::vector<float>{0.5F, odd}, {}, {}});
        CHECK_FALSE(Texels(image, {}).zeros());
    }
    const auto image =
        std::make_shared<const Image>(Image{1, 1, 1, std::vector<float>{0.5F}, {}, {}});
    CHECK_FALSE(Texels(image, {"", Wrap::repeat, false, -1}).zeros());
    CHECK(Texels(image, {"", Wrap::repeat, false, 0}).zeros()->is_zero({0.3, 0.2}));
}
