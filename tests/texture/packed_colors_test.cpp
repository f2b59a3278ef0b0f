#include "core/texture/packed_colors.h"

#include "core/image/image.h"
#include "tests/catch.h"

using namespace etalon;

namespace {

/// Returns the largest error of a channel of a packed 8-bit colour, in steps of 1/255.
double largest_error(const std::array<float, 256>& bytes, int channel) {
    double largest = 0;
    for (std::size_t i = 1; i < 256; ++i) {
        const float value = bytes[i];
        const double error = std::abs(unpacked(packed(Color(value)))[channel] - value);
        largest = std::max(largest, error / (value - bytes[i - 1]));
    }
    return largest;
}

}  // namespace

TEST_CASE("packed colours are off by less than a third of a byte", "[texture]") {
    CHECK(largest_error(detail::byte_values, 0) < 0.15);
    CHECK(largest_error(detail::byte_values, 1) < 0.15);
    CHECK(largest_error(detail::byte_values, 2) < 0.3);
    CHECK(largest_error(decoded_byte_values(), 1) < 0.1);
    CHECK(largest_error(decoded_byte_values(), 2) < 0.2);
}

TEST_CASE("channels are packed apart from each other", "[texture]") {
    const Color color = unpacked(packed({1, 0, 0.0625F}));
    CHECK(color.x == 1);
    CHECK(color.y == 0);
    CHECK(std::abs(color.z - 0.0625F) < 3e-4F);
    CHECK(unpacked(packed({0, 1, 0})) == Color(0, 1, 0));
}

TEST_CASE("what stretching can make of white is packed, and more is as bright as can be",
          "[texture]") {
    CHECK(std::abs(unpacked(packed(Color(81 / 64.0F))).x - 81 / 64.0F) < 1.3e-3F);
    CHECK(unpacked(packed(Color(1e9F))) == unpacked(packed(Color(1.3F))));
}
