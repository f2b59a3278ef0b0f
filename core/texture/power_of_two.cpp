#include "core/texture/power_of_two.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/parallel/parallel.h"

namespace etalon {
namespace {

constexpr double radius = 2;  ///< radius of the filter, in texels of the source image

constexpr std::size_t rows_a_task = 32;

/// The texels of a row or column that make up one of the stretched image: -1 is black.
struct Sources {
    std::array<int, 4> texels;
    std::array<float, 4> weights;
};

/// Returns a sinc windowed by another that is 0 at the radius.
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
    const int stretched = next_power_of_two(count);
    std::vector<Sources> list;
    list.reserve(static_cast<std::size_t>(stretched));
    for (int i = 0; i < stretched; ++i) list.push_back(sources(i, stretched, count, wrap));
    return list;
}

/// Stretches a row of texels.
template <std::size_t channels>
void stretch_row(const float* row, const std::vector<Sources>& columns, float* stretched) {
    for (const Sources& from : columns) {
        std::array<float, channels> sums{};
        for (std::size_t j = 0; j < 4; ++j) {
            if (from.texels[j] < 0) continue;
            const float* const texel = row + static_cast<std::size_t>(from.texels[j]) * channels;
            for (std::size_t k = 0; k < channels; ++k) sums[k] += from.weights[j] * texel[k];
        }
        stretched = std::copy_n(sums.data(), channels, stretched);
    }
}

/// Stretched rows of an image, of which the most recently used ones are kept.
class LongerRows {
  public:
    LongerRows(const TexelRows& image, const std::vector<Sources>& columns)
        : image_(image),
          columns_(columns),
          row_(static_cast<std::size_t>(image.width) * image.channels) {
        for (std::vector<float>& row : rows_) row.resize(columns.size() * image.channels);
    }

    const float* operator[](int number) {
        const auto place = static_cast<std::size_t>(number) % rows_.size();
        float* const row = rows_[place].data();
        if (numbers_[place] == number) return row;
        numbers_[place] = number;
        image_.read(number, row_.data());
        const float* const from = row_.data();
        image_.channels == 1 ? stretch_row<1>(from, columns_, row)
                             : stretch_row<3>(from, columns_, row);
        return row;
    }

  private:
    const TexelRows& image_;
    const std::vector<Sources>& columns_;
    std::vector<float> row_;  ///< as it is in the image
    std::array<std::vector<float>, 4> rows_;
    std::array<int, 4> numbers_ = {-1, -1, -1, -1};
};

/// Returns the weighted mean of four rows, of numbers not below 0.
void mix_rows(const Sources& from, LongerRows& rows, std::span<float> mixed) {
    std::ranges::fill(mixed, 0.0F);
    for (std::size_t j = 0; j < 4; ++j) {
        if (from.texels[j] < 0) continue;
        const float* const row = rows[from.texels[j]];
        for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i] += from.weights[j] * row[i];
    }
    for (float& value : mixed) value = std::max(value, 0.0F);
}

}  // namespace

bool has_power_of_two_sides(int width, int height) {
    return std::has_single_bit(static_cast<unsigned>(width)) &&
           std::has_single_bit(static_cast<unsigned>(height));
}

void stretch_to_powers_of_two(const TexelRows& image, Wrap wrap, const RowUser& use) {
    const std::vector<Sources> columns = all_sources(image.width, wrap);
    const std::vector<Sources> rows = all_sources(image.height, wrap);
    parallel_for(rows.size(), rows_a_task, [&](std::size_t begin, std::size_t end) {
        LongerRows longer(image, columns);
        std::vector<float> mixed(columns.size() * image.channels);
        for (std::size_t y = begin; y < end; ++y) {
            mix_rows(rows[y], longer, mixed);
            use(static_cast<int>(y), mixed);
        }
    });
}

void for_each_stretched_row(const TexelRows& image, Wrap wrap, const RowUser& use) {
    if (!has_power_of_two_sides(image.width, image.height)) {
        stretch_to_powers_of_two(image, wrap, use);
        return;
    }
    const auto length = static_cast<std::size_t>(image.width) * image.channels;
    parallel_for(static_cast<std::size_t>(image.height), rows_a_task,
                 [&](std::size_t begin, std::size_t end) {
                     std::vector<float> row(length);
                     for (std::size_t y = begin; y < end; ++y) {
                         image.read(static_cast<int>(y), row.data());
                         use(static_cast<int>(y), row);
                     }
                 });
}

}  // namespace etalon
