#include "core/texture/texture_values.h"

#include <cmath>

#include "tests/catch.h"

using namespace etalon;

namespace {

float number_at(const Textures& textures, const TexturePoint& point) {
    std::vector<std::string> problems;
    const TextureValues values(textures, problems);
    const auto last = static_cast<std::uint32_t>(textures.numbers.size() - 1);
    return values.number({0, last}, point);
}

Color color_at(const Textures& textures, const TexturePoint& point) {
    std::vector<std::string> problems;
    const TextureValues values(textures, problems);
    const auto last = static_cast<std::uint32_t>(textures.colors.size() - 1);
    return values.color({Color(0.0F), last}, point);
}

TexturePoint at_uv(double u, double v) {
    return {{u, v}, {0, 0, 0}};
}

TexturePoint at_position(double x, double y, double z) {
    return {{0, 0}, {x, y, z}};
}

}  // namespace

TEST_CASE("a slot without a texture is its value", "[texture]") {
    std::vector<std::string> problems;
    const Textures none;
    const TextureValues values(none, problems);
    CHECK(values.number({0.3F}, at_uv(0, 0)) == 0.3F);
    CHECK(values.color({{1, 2, 3}}, at_uv(0, 0)) == Color(1, 2, 3));
    CHECK(problems.empty());
}

TEST_CASE("a constant texture is its value and not the slot's", "[texture]") {
    CHECK(number_at({{ConstantTexture<float>{0.7F}}, {}, {}}, at_uv(0, 0)) == 0.7F);
    CHECK(color_at({{}, {ConstantTexture<Color>{{1, 2, 3}}}, {}}, at_uv(0, 0)) == Color(1, 2, 3));
}

TEST_CASE("a scale texture is the product of two slots, channel by channel", "[texture]") {
    const Textures textures{{},
                            {ConstantTexture<Color>{{1, 2, 3}},
                             ScaleTexture<Color>{{Color(9.0F), 0}, {{0.5F, 0.25F, 2}}}},
                            {}};
    CHECK(color_at(textures, at_uv(0, 0)) == Color(0.5F, 0.5F, 6));
}

TEST_CASE("a mix texture is the second slot at an amount of 1", "[texture]") {
    const auto mixed = [](float amount) {
        const Textures textures{
            {ConstantTexture<float>{amount}, MixTexture<float>{{2}, {10}, {0, 0}}}, {}, {}};
        return number_at(textures, at_uv(0, 0));
    };
    CHECK(mixed(0) == 2);
    CHECK(mixed(1) == 10);
    CHECK(mixed(0.25F) == 4);
}

TEST_CASE("a bilinear texture has its second value at v = 1 and its third at u = 1", "[texture]") {
    const Textures textures{{BilinearTexture<float>{UvMapping{}, 1, 2, 4, 8}}, {}, {}};
    CHECK(number_at(textures, at_uv(0, 0)) == 1);
    CHECK(number_at(textures, at_uv(0, 1)) == 2);
    CHECK(number_at(textures, at_uv(1, 0)) == 4);
    CHECK(number_at(textures, at_uv(1, 1)) == 8);
    CHECK(number_at(textures, at_uv(0.5, 0.25)) == 3.125F);
    CHECK(number_at(textures, at_uv(2, 0)) == 7);
}

TEST_CASE("a uv texture has the coordinates modulo 1 in red and green", "[texture]") {
    const Textures textures{{}, {UvTexture{UvMapping{}}}, {}};
    CHECK(color_at(textures, at_uv(0.25, 0.5)) == Color(0.25F, 0.5F, 0));
    CHECK(color_at(textures, at_uv(-0.25, 3.5)) == Color(0.75F, 0.5F, 0));
}

TEST_CASE("a uv texture of numbers is the luminance of those colours", "[texture]") {
    const Textures textures{{UvTexture{UvMapping{}}}, {}, {}};
    CHECK(std::abs(number_at(textures, at_uv(0.25, 0.5)) - 0.41074775F) < 1e-6);
}

TEST_CASE("a checkerboard's fields alternate along both coordinates, below zero too", "[texture]") {
    const Textures textures{{Checkerboard2<float>{UvMapping{2, 2, 0, 0}, {1}, {0}}}, {}, {}};
    CHECK(number_at(textures, at_uv(0.25, 0.25)) == 1);
    CHECK(number_at(textures, at_uv(0.75, 0.25)) == 0);
    CHECK(number_at(textures, at_uv(0.25, 0.75)) == 0);
    CHECK(number_at(textures, at_uv(0.75, 0.75)) == 1);
    CHECK(number_at(textures, at_uv(-0.25, 0.25)) == 0);
    CHECK(number_at(textures, at_uv(-0.25, -0.25)) == 1);
}

TEST_CASE("the fields of a checkerboard may be textures themselves", "[texture]") {
    const Textures textures{{},
                            {UvTexture{UvMapping{}},
                             Checkerboard2<Color>{UvMapping{}, {Color(9.0F), 0}, {Color(7.0F)}}},
                            {}};
    CHECK(color_at(textures, at_uv(0.25, 0.5)) == Color(0.25F, 0.5F, 0));
    CHECK(color_at(textures, at_uv(1.25, 0.5)) == Color(7.0F));
}

TEST_CASE("a checkerboard in space alternates along three axes of its own", "[texture]") {
    const Affine doubled{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {0, 0, 1}};
    const Textures textures{{Checkerboard3<float>{doubled, {1}, {0}}}, {}, {}};
    CHECK(number_at(textures, at_position(0.25, 0.25, 0.25)) == 0);
    CHECK(number_at(textures, at_position(0.75, 0.25, 0.25)) == 1);
    CHECK(number_at(textures, at_position(0.25, 0.75, 0.25)) == 1);
    CHECK(number_at(textures, at_position(0.25, 0.25, 0.75)) == 1);
    CHECK(number_at(textures, at_position(-0.25, -0.25, 0.25)) == 0);
}

TEST_CASE("Checkerboard: given hits of a plane between checks, then all are of the upper check",
          "[texture]") {
    const Textures in_space{{Checkerboard3<float>{{}, {1}, {0}}}, {}, {}};
    const Textures on_plane{{Checkerboard2<float>{PlanarMapping{}, {1}, {0}}}, {}, {}};
    for (const double x : {-3.0, 0.0, 1.0, 7.0, 1000.0}) {
        const double rounding = 1e-14 * (1 + std::abs(x));
        const float upper = std::fmod(std::abs(x), 2) == 0 ? 1 : 0;
        for (const double hit : {x - rounding, x, x + rounding}) {
            CHECK(number_at(in_space, at_position(hit, 0.5, 0.5)) == upper);
            CHECK(number_at(on_plane, at_position(hit, 0.5, 0.5)) == upper);
        }
    }
}
