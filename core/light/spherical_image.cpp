#include "core/light/spherical_image.h"

#include <numbers>

#include "core/image/io.h"
#include "core/parallel/large_pages.h"
#include "core/texture/power_of_two.h"

namespace etalon {
namespace {

/// The colours of an image, by rows.
std::vector<Color> colors_of(const Image& image) {
    std::vector<Color> colors;
    colors.reserve(static_cast<std::size_t>(image.width) * image.height);
    prefer_large_pages(colors.data(), colors.capacity() * sizeof(Color));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) colors.push_back(image.color(x, y));
    }
    return colors;
}

/// The same with sides of powers of two, as pbrt-v3 makes it.
TexelGrid stretched(const Image& image) {
    TexelGrid grid{image.width, image.height, 3, {}};
    for (const Color& c : colors_of(image)) {
        grid.values.insert(grid.values.end(), {c.x, c.y, c.z});
    }
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
    width_ = image.value.width;
    height_ = image.value.height;
    aspect_ = static_cast<double>(width_) / height_;
    if (has_power_of_two_sides(width_, height_)) {
        texels_ = colors_of(image.value);
        return;
    }
    const TexelGrid grid = stretched(image.value);
    width_ = grid.width;
    height_ = grid.height;
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
