#include "core/texture/power_of_two.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "core/parallel/parallel.h"

namespace etalon {
namespace {

constexpr double radius = 2;  ///< of the filter, in texels of the image that is stretched

/// The texels of a row or column that make one of the stretched image: -1 is black.
struct Sources {
    std::array<int, 4> texels;
    std::array<float, 4> weights;
};

/// A sinc under another that is 0 at the radius.
double lanczos(double distance) {
    const double x = std::abs(distance) / radius * std::numbers::pi;
    if (x < 1e-5) return 1;
    if (x > std::numbers::pi) return 0;
    return std::sin(radius * x) / (radius * x) * std::sin(x) / x;
}

int wrapped(int index, int count, Wrap wrap) {
    if (wrap == Wrap::clamp) return std::clamp(index, 0, count - 1);
    if (wrap == Wrap::repeat) return ((index % count) + count) % count;
    return index >= 0 && index < count ? index : -1;
}

Sources sources(int number, int stretched, int count, Wrap wrap) {
    const double centre = (number + 0.5) * count / stretched;
    const int first = static_cast<int>(std::floor(centre - radius + 0.5));
    std::array<double, 4> weights{};
    double sum = 0;
    for (int j = 0; j < 4; ++j) sum += weights[j] = lanczos(first + j + 0.5 - centre);
    Sources result{};
    for (int j = 0; j < 4; ++j) {
        result.texels[j] = wrapped(first + j, count, wrap);
        result.weights[j] = static_cast<float>(weights[j] / sum);
    }
    return result;
}

std::vector<Sources> all_sources(int count, Wrap wrap) {
    const int stretched = static_cast<int>(std::bit_ceil(static_cast<unsigned>(count)));
    std::vector<Sources> list;
    list.reserve(static_cast<std::size_t>(stretched));
    for (int i = 0; i < stretched; ++i) list.push_back(sources(i, stretched, count, wrap));
    return list;
}

/// Adds up what `width` numbers at each source give.
void add_sources(const Sources& from, const float* values, std::size_t width, std::size_t stride,
                 float* sums) {
    std::fill_n(sums, width, 0.0F);
    for (std::size_t j = 0; j < 4; ++j) {
        if (from.texels[j] < 0) continue;
        const float* const source = values + static_cast<std::size_t>(from.texels[j]) * stride;
        for (std::size_t i = 0; i < width; ++i) sums[i] += from.weights[j] * source[i];
    }
}

template <class Line>
void for_all_lines(int count, const Line& line) {
    parallel_for(static_cast<std::size_t>(count), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) line(i);
    });
}

TexelGrid stretched_rows(const TexelGrid& image, Wrap wrap) {
    const std::vector<Sources> columns = all_sources(image.width, wrap);
    TexelGrid result{static_cast<int>(columns.size()), image.height, image.channels, {}};
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t before = static_cast<std::size_t>(image.width) * channels;
    const std::size_t after = columns.size() * channels;
    result.values.resize(after * static_cast<std::size_t>(image.height));
    for_all_lines(image.height, [&](std::size_t y) {
        for (std::size_t x = 0; x < columns.size(); ++x) {
            add_sources(columns[x], &image.values[y * before], channels, channels,
                        &result.values[y * after + x * channels]);
        }
    });
    return result;
}

TexelGrid stretched_columns(const TexelGrid& image, Wrap wrap) {
    const std::vector<Sources> rows = all_sources(image.height, wrap);
    TexelGrid result{image.width, static_cast<int>(rows.size()), image.channels, {}};
    const std::size_t row = static_cast<std::size_t>(image.width) * image.channels;
    result.values.resize(row * rows.size());
    for_all_lines(result.height, [&](std::size_t y) {
        float* const sums = &result.values[y * row];
        add_sources(rows[y], image.values.data(), row, row, sums);
        for (std::size_t i = 0; i < row; ++i) sums[i] = std::max(sums[i], 0.0F);
    });
    return result;
}

}  // namespace

bool has_power_of_two_sides(int width, int height) {
    return std::has_single_bit(static_cast<unsigned>(width)) &&
           std::has_single_bit(static_cast<unsigned>(height));
}

TexelGrid stretched_to_powers_of_two(const TexelGrid& image, Wrap wrap) {
    return stretched_columns(stretched_rows(image, wrap), wrap);
}

}  // namespace etalon
