#include "core/texture/procedural.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/texture/fractal_noise.h"
#include "core/texture/gradient_noise.h"

namespace etalon {
namespace {

/// Returns point `t` of the Bezier curve whose control points are the four from `first` on.
Color bezier(const Color* first, float t) {
    std::array<Color, 4> c{};
    std::copy_n(first, 4, c.begin());
    for (std::size_t n = 3; n > 0; --n) {
        for (std::size_t i = 0; i < n; ++i) c[i] = c[i] * (1 - t) + c[i + 1] * t;
    }
    return c[0];
}

/// Returns the colour of a vein at `t` from 0 to 1. There are six segments, but pbrt-v3 continues
/// the second to the end instead of using those after it, where values get far above 1.
Color vein(double t) {
    constexpr double segments = 6;
    static const std::array<Color, 5> control = {{
        {0.58F, 0.58F, 0.6F},
        {0.58F, 0.58F, 0.6F},
        {0.58F, 0.58F, 0.6F},
        {0.5F, 0.5F, 0.5F},
        {0.6F, 0.59F, 0.58F},
    }};
    const std::size_t first = t * segments < 1 ? 0 : 1;
    return 1.5F * bezier(&control[first], static_cast<float>(t * segments - double(first)));
}

/// Returns noise in the plane.
double noise_2d(double x, double y) {
    return gradient_noise({x, y, 0.5});
}

}  // namespace

float procedural_value(const FbmTexture& texture, const Vec3& position) {
    const Vec3 p = texture.to_texture.point(position);
    return static_cast<float>(fractional_brownian_motion(texture.noise, p));
}

float procedural_value(const WrinkledTexture& texture, const Vec3& position) {
    return static_cast<float>(turbulence(texture.noise, texture.to_texture.point(position)));
}

float procedural_value(const WindyTexture& texture, const Vec3& position) {
    const Vec3 p = texture.to_texture.point(position);
    const double wind = fractional_brownian_motion({3, 0.5F}, 0.1 * p);
    const double waves = fractional_brownian_motion({windy_octaves, 0.5F}, p);
    return static_cast<float>(std::abs(wind) * waves);
}

Color procedural_value(const MarbleTexture& texture, const Vec3& position) {
    const Vec3 p = double(texture.scale) * texture.to_texture.point(position);
    const double phase = p.y + texture.variation * fractional_brownian_motion(texture.noise, p);
    return vein(0.5 + 0.5 * std::sin(phase));
}

bool is_in_dot(const Vec2& st) {
    constexpr double radius = 0.35, largest_shift = 0.5 - radius;
    const Vec2 cell(std::floor(st.x + 0.5), std::floor(st.y + 0.5));
    if (!(noise_2d(cell.x + 0.5, cell.y + 0.5) > 0)) return false;
    const Vec2 shift(noise_2d(cell.x + 1.5, cell.y + 2.8), noise_2d(cell.x + 4.5, cell.y + 9.8));
    const Vec2 from_centre = st - (cell + largest_shift * shift);
    return from_centre.dot(from_centre) < radius * radius;
}

}  // namespace etalon
