#include "core/image/encode.h"

#include <bit>

#include <cmath>
#include <limits>

#include "core/color/srgb.h"
#include "core/image/image.h"
#include "core/numerics/random.h"
#include "tests/catch.h"
#include "tests/image/srgb_definition.h"

using namespace etalon;
using etalon::test::linear_of;

namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// The same by the formula.
int byte_by_powers(float linear) {
    return static_cast<int>(255 * srgb_encoded(displayed(linear)) + 0.5);
}

/// Returns the number of floats in a range of bit patterns with a different byte.
std::size_t others(std::uint32_t first, std::uint32_t last) {
    std::size_t count = 0;
    for (std::uint32_t bits = first; bits <= last; ++bits) {
        const auto value = std::bit_cast<float>(bits);
        count += srgb_byte(value) != byte_by_powers(value);
    }
    return count;
}

constexpr auto bits_of_one = std::bit_cast<std::uint32_t>(1.0F);

}  // namespace

TEST_CASE("known linear values have the sRGB bytes of the standard's curve") {
    struct Row {
        float linear;
        int byte;
    };
    const Row rows[] = {{0, 0},      {0.0001F, 0},      {0.001F, 3}, {0.0031308F, 10}, {0.01F, 25},
                        {0.05F, 63}, {0.18F, 118},      {0.5F, 188}, {0.9F, 243},      {0.99F, 254},
                        {1, 255},    {2, 255},          {inf, 255},  {-0.0F, 0},       {-1, 0},
                        {-inf, 0},   {not_a_number, 0}, {1e-45F, 0}, {0.2158605F, 128}};
    for (const Row& row : rows) {
        INFO(row.linear);
        CHECK(int(srgb_byte(row.linear)) == row.byte);
    }
}

TEST_CASE("sRGB bytes are rounded to nearest: each changes half way between its neighbours") {
    for (int byte = 0; byte < 256; ++byte) {
        INFO(byte);
        CHECK(int(srgb_byte(static_cast<float>(linear_of(byte / 255.0)))) == byte);
        if (byte == 255) break;
        CHECK(int(srgb_byte(static_cast<float>(linear_of((byte + 0.49) / 255.0)))) == byte);
        CHECK(int(srgb_byte(static_cast<float>(linear_of((byte + 0.51) / 255.0)))) == byte + 1);
    }
}

TEST_CASE("sRGB bytes are those of the curve's formula, next to each change and anywhere") {
    for (int byte = 1; byte < 256; ++byte) {
        const auto change = static_cast<float>(linear_of((byte - 0.5) / 255));
        const auto bits = std::bit_cast<std::uint32_t>(change);
        CHECK(others(bits - 100, std::min(bits + 100, bits_of_one)) == 0);
    }
    Random random(3);
    for (int i = 0; i < 1'000'000; ++i) {
        const std::uint32_t bits = random.index(bits_of_one);
        if (others(bits, bits) != 0) FAIL(std::bit_cast<float>(bits));
    }
}

TEST_CASE("all floats up to 1 have the byte of the curve's formula", "[long]") {
    CHECK(others(0, bits_of_one) == 0);
}

TEST_CASE("display values become bytes by truncation of 255.99 times the value") {
    struct Row {
        float value;
        int byte;
    };
    const Row rows[] = {{0, 0},        {0.5F, 127},      {0.25F, 63},    {0.0039F, 0},
                        {0.00391F, 1}, {0.996F, 254},    {0.9961F, 254}, {0.9962F, 255},
                        {1, 255},      {1.5F, 255},      {inf, 255},     {-1, 0},
                        {-inf, 0},     {not_a_number, 0}};
    for (const Row& row : rows) {
        INFO(row.value);
        CHECK(int(display_byte(row.value)) == row.byte);
    }
    for (int byte = 0; byte < 256; ++byte) {
        CHECK(int(display_byte(static_cast<float>((byte + 0.001) / 255.99))) == byte);
        CHECK(int(display_byte(static_cast<float>((byte + 0.999) / 255.99))) ==
              std::min(byte, 255));
    }
}

TEST_CASE("exposure doubles with each stop, before the curve and before the clamp") {
    RenderedImage image{2,     1, {{0, 0}, {1, 0}}, {{0.09F, 0.25F, 3}, {not_a_number, inf, -1}},
                        false, {}};
    CHECK(display_bytes(image, 1) == std::vector<std::uint8_t>{118, 188, 255, 0, 255, 0});
    CHECK(display_bytes(image, -2)[2] == srgb_byte(0.75F));
}

TEST_CASE("exposure of display values is that of the light they stand for") {
    RenderedImage shown{3, 1, {{0, 0}, {2, 0}}, {}, true, {}};
    shown.pixels = {{0.09F, 0.25F, 0.5F}, {0.75F, 1, 1.5F}, {not_a_number, inf, -1}};
    RenderedImage light = shown;
    light.display_colors = false;
    decode(light.pixels);
    for (const double stops : {-3.0, -1.0, 0.5, 1.0}) {
        const auto a = display_bytes(shown, stops), b = display_bytes(light, stops);
        for (std::size_t i = 0; i < a.size(); ++i) {
            CAPTURE(stops, i);
            CHECK(std::abs(a[i] - b[i]) <= 1);
        }
    }
}
