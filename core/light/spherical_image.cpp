#include "core/light/spherical_image.h"

#include <numbers>

#include "core/image/io.h"
#include "core/parallel/large_pages.h"
#include "core/texture/shown_rows.h"

namespace etalon {

SphericalImage::SphericalImage(const std::string& file, std::vector<std::string>& problems) {
    if (file.empty()) return;
    const Result<Image> image = read_image(file);
    if (!image) {
        problems.push_back(image.error);
        return;
    }
    aspect_ = static_cast<double>(image.value.width) / image.value.height;
    width_ = next_power_of_two(image.value.width);
    height_ = next_power_of_two(image.value.height);
    const auto width = static_cast<std::size_t>(width_);
    texels_.reserve(width * height_);
    prefer_large_pages(texels_.data(), texels_.capacity() * sizeof(Color));
    texels_.resize(width * height_);
    const TexelRows rows = shown_rows(image.value, Shown::colors, false);
    for_each_stretched_row(rows, Wrap::repeat, [&](int y, std::span<const float> row) {
        for (std::size_t x = 0; x < width; ++x) {
            const float* const p = &row[x * rows.channels];
            texels_[y * width + x] = rows.channels == 1 ? Color(p[0]) : Color(p[0], p[1], p[2]);
        }
    });
}

const Color& SphericalImage::texel(int x, int y) const {
    if (x < 0 || x >= width_) x = (x % width_ + width_) % width_;
    if (y < 0 || y >= height_) y = (y % height_ + height_) % height_;
    return texels_[static_cast<std::size_t>(y) * width_ + x];
}

Color SphericalImage::at(const Vec2& place) const {
    const double x = place.x * width_ - 0.5, y = place.y * height_ - 0.5;
    const double left = std::floor(x), top = std::floor(y);
    const auto i = static_cast<int>(left), j = static_cast<int>(top);
    const auto u = static_cast<float>(x - left), v = static_cast<float>(y - top);
    return (1 - v) * ((1 - u) * texel(i, j) + u * texel(i + 1, j)) +
           v * ((1 - u) * texel(i, j + 1) + u * texel(i + 1, j + 1));
}

Vec2 SphericalImage::place_of(const Vec3& d) {
    constexpr double pi = std::numbers::pi;
    const double phi = std::atan2(d.y, d.x);
    return {(phi < 0 ? phi + 2 * pi : phi) / (2 * pi), std::atan2(std::hypot(d.x, d.y), d.z) / pi};
}

Vec3 SphericalImage::direction_at(const Vec2& place) {
    constexpr double pi = std::numbers::pi;
    const double theta = pi * place.y, phi = 2 * pi * place.x, sine = std::sin(theta);
    return {sine * std::cos(phi), sine * std::sin(phi), std::cos(theta)};
}

}  // namespace etalon
