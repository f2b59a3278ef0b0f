#include "core/texture/power_of_two.h"

#include <algorithm>
#include <atomic>
#include <vector>

#include "tests/catch.h"

using namespace etalon;

namespace {

/// Values of the texels of an image by rows, channels interleaved.
struct TexelGrid {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;
};

TexelGrid stretched(const TexelGrid& image, Wrap wrap) {
    const auto row = static_cast<std::size_t>(image.width) * image.channels;
    const TexelRows rows{image.width, image.height, image.channels, [&](int y, float* texels) {
                             std::copy_n(&image.values[y * row], row, texels);
                         }};
    TexelGrid result{
        next_power_of_two(image.width), next_power_of_two(image.height), image.channels, {}};
    const std::size_t length = static_cast<std::size_t>(result.width) * image.channels;
    result.values.resize(length * result.height);
    std::atomic<int> count = 0;
    stretch_to_powers_of_two(rows, wrap, [&](int y, std::span<const float> texels) {
        if (texels.size() == length) std::ranges::copy(texels, &result.values[y * length]);
        ++count;
    });
    CHECK(count == result.height);
    return result;
}

/// Returns a resampled row of texels.
std::vector<float> stretched(const std::vector<float>& row, Wrap wrap) {
    return stretched(TexelGrid{static_cast<int>(row.size()), 1, 1, row}, wrap).values;
}

void check_near(const std::vector<float>& found, const std::vector<double>& expected) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        INFO(i);
        CHECK(std::abs(found[i] - expected[i]) < 1e-6);
    }
}

}  // namespace

// The numbers were computed from the formulas of the book by another program.
TEST_CASE("a row of three texels becomes one of four, by what is beyond its ends", "[texture]") {
    const std::vector<float> row = {0.2F, 0.8F, 0.5F};
    check_near(stretched(row, Wrap::repeat),
               {0.1911913028778647, 0.6006883920347823, 0.7542353213509225, 0.4510343531280255});
    check_near(stretched(row, Wrap::black),
               {0.1451104598059822, 0.6200648332592115, 0.7619858978406941, 0.4346610422634143});
    check_near(stretched(row, Wrap::clamp),
               {0.1640575536257706, 0.6123142567694398, 0.742609456616265, 0.4820287768128854});
}

TEST_CASE("what a filter with negative weights would make less than black is black", "[texture]") {
    check_near(stretched({0, 0, 1, 0, 0}, Wrap::clamp),
               {0, 0, 0.0447248010835575, 0.8024450774424889, 0.8024450774424889,
                0.0447248010835575, 0, 0});
}

TEST_CASE("an image of one colour keeps it, and rows and columns are stretched alike",
          "[texture]") {
    const TexelGrid one{3, 5, 3, std::vector<float>(45, 0.25F)};
    const TexelGrid grid = stretched(one, Wrap::repeat);
    CHECK(grid.width == 4);
    CHECK(grid.height == 8);
    CHECK(grid.channels == 3);
    check_near(grid.values, std::vector<double>(96, 0.25));

    const std::vector<float> values = {0.1F, 0.7F, 0.3F, 0.9F, 0.2F, 0.6F};
    const TexelGrid wide = stretched(TexelGrid{6, 1, 1, values}, Wrap::clamp);
    const TexelGrid high = stretched(TexelGrid{1, 6, 1, values}, Wrap::clamp);
    CHECK(wide.width == 8);
    CHECK(high.height == 8);
    CHECK(wide.values == high.values);
}

TEST_CASE("channels are stretched apart from each other", "[texture]") {
    const TexelGrid grid =
        stretched(TexelGrid{3, 1, 3, {0.2F, 1, 0, 0.8F, 1, 0, 0.5F, 1, 0}}, Wrap::repeat);
    check_near({grid.values[0], grid.values[3], grid.values[6], grid.values[9]},
               {0.1911913028778647, 0.6006883920347823, 0.7542353213509225, 0.4510343531280255});
    check_near({grid.values[1], grid.values[4], grid.values[2]}, {1, 1, 0});
}

TEST_CASE("sides of powers of two are left as they are", "[texture]") {
    CHECK(has_power_of_two_sides(1, 1));
    CHECK(has_power_of_two_sides(64, 1024));
    CHECK_FALSE(has_power_of_two_sides(64, 1000));
    CHECK_FALSE(has_power_of_two_sides(3, 4));
}
