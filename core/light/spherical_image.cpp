#include "core/light/spherical_image.h"

#include <numbers>

#include "core/image/io.h"
#include "core/parallel/large_pages.h"
#include "core/texture/power_of_two.h"

namespace etalon {
namespace {

/// The colours of an image with sides of powers of two, as pbrt-v3 makes it of any other.
TexelGrid texels_of(const Image& image) {
    TexelGrid grid{image.width, image.height, 3, {}};
    grid.values.reserve(std::size_t{3} * image.width * image.height);
    prefer_large_pages(grid.values.data(), grid.values.capacity() * sizeof(float));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Color c = image.color(x, y);
            grid.values.insert(grid.values.end(), {c.x, c.y, c.z});
        }
    }
    if (has_power_of_two_sides(image.width, image.height)) return grid;
    return stretched_to_powers_of_two(grid, Wrap::repeat);
}

}  // namespace

SphericalImage::SphericalImage(const std::string& file, std::vector<std::string>& problems) {
    if (file.empty()) return;
    const Result<Image> image = read_image(file);
    if (!image) {
        problems.push_back(image.error);
        return;
    }
    const TexelGrid grid = texels_of(image.value);
    aspect_ = static_cast<double>(image.value.width) / image.value.height;
    width_ = grid.width;
    height_ = grid.height;
    texels_.reserve(grid.values.size() / 3);
    prefer_large_pages(texels_.data(), texels_.capacity() * sizeof(Color));
    for (std::size_t i = 0; i < grid.values.size(); i += 3) {
        texels_.emplace_back(grid.values[i], grid.values[i + 1], grid.values[i + 2]);
    }
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
