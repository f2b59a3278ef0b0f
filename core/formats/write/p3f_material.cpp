#include "core/formats/write/p3f_material.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace etalon {
namespace {

const Color black(0.0F), white(1.0F);

/// Calls try_one(candidate) for the floats around x, nearest first, until one fits.
template <class F>
bool try_neighbours(float x, int count, F&& try_one) {
    float above = x, below = x;
    if (try_one(x)) return true;
    for (int i = 0; i < count; ++i) {
        above = std::nextafter(above, HUGE_VALF);
        below = std::nextafter(below, -HUGE_VALF);
        if (try_one(above) || try_one(below)) return true;
    }
    return false;
}

int largest_component(const Color& c) {
    return dominant_axis(Vec3(c.x, c.y, c.z));
}

/// Returns the Ks for which `color` Ks is `product`, or as near as possible.
float factor_of(const Color& color, const Color& product) {
    const int k = largest_component(color);
    if (color[k] == 0) return 0;
    float factor = product[k] / color[k];
    const auto fits = [&](float x) { return color * x == product && (factor = x, true); };
    try_neighbours(factor, 8, fits);
    return factor;
}

/// Writes a surface without glass. A negative Ks, of a negative colour, is a highlight without a
/// mirror.
P3fMaterial opaque(const Material& m) {
    P3fMaterial n;
    n.diffuse = m.diffuse;
    n.shine = m.shininess;
    if (m.reflection != black) {
        n.specular = m.reflection;
        n.ks = 1;
    } else if (m.specular != black) {
        n.specular = -m.specular;
        n.ks = -1;
    }
    return n;
}

/// Returns the Cd for which Cd Kd is the diffuse colour and 1 - Cd the absorption.
std::optional<Color> diffuse_of_glass(const Material& m, float kd) {
    Color diffuse;
    for (int k = 0; k < 3; ++k) {
        const auto fits = [&](float cd) {
            diffuse[k] = cd;
            return cd * kd == m.diffuse[k] && std::max(0.0F, 1 - cd) == m.absorption[k];
        };
        const float guess = kd == 0 ? 1 - m.absorption[k] : m.diffuse[k] / kd;
        if (!try_neighbours(guess, 2, fits)) return std::nullopt;
    }
    return diffuse;
}

struct Interval {
    double low, high;
};

/// Returns all Kd for which some Cd with the right absorption has the right diffuse colour. Below
/// 1/2 a Cd has more digits than 1 - Cd tells.
Interval range_of_kd(const Material& m) {
    Interval range{0, std::numeric_limits<float>::max()};
    for (int k = 0; k < 3; ++k) {
        const double a = m.absorption[k], d = m.diffuse[k];
        if (d <= 0) continue;
        const double error_bound = 0x1p-24 * std::max(a, 1.0);
        if (a > 0) range.low = std::max(range.low, d / (1 - a + error_bound));
        if (1 - a > error_bound) range.high = std::min(range.high, d / (1 - a - error_bound));
    }
    return range;
}

/// Writes glass whose absorption is the complement of its diffuse colour.
std::optional<P3fMaterial> absorbing_glass(const Material& m) {
    constexpr int tries = 256;
    P3fMaterial n;
    const auto fits = [&](float kd) {
        const std::optional<Color> diffuse = diffuse_of_glass(m, kd);
        if (diffuse) n.diffuse = *diffuse, n.kd = kd;
        return diffuse.has_value();
    };
    if (m.diffuse == black && fits(0)) return n;
    const Interval range = range_of_kd(m);
    for (int i = 0; i <= tries; ++i) {
        const double kd = range.low + (range.high - range.low) * i / tries;
        if (try_neighbours(static_cast<float>(kd), 1, fits)) return n;
    }
    return std::nullopt;
}

P3fStatement glass(const Material& m) {
    P3fStatement s{{}, false};
    s.numbers.diffuse = m.diffuse;
    if (m.absorption != black) {
        const std::optional<P3fMaterial> absorbing = absorbing_glass(m);
        s.absorbs = true;
        if (absorbing) s.numbers = *absorbing;
        if (!absorbing) s.numbers.diffuse = white - m.absorption, s.numbers.kd = 0;
    }
    s.numbers.specular = m.fresnel ? m.reflection : white;
    s.numbers.ks = factor_of(s.numbers.specular, m.specular);
    s.numbers.shine = m.shininess;
    s.numbers.transmission = 1;
    if (m.ior > 0) s.numbers.ior = m.ior;
    return s;
}

/// Adds a warning for each difference from the material that the statement gives.
void compare(const Material& wanted, const Material& got, ConversionWarnings& lost) {
    const auto check = [&](bool same, const char* what) {
        if (!same) lost.add(what);
    };
    check(wanted.ambient == black, "ambient colour of a material");
    check(wanted.diffuse == got.diffuse, "diffuse colour of an absorbing glass");
    check(wanted.specular == black || wanted.highlight == got.highlight,
          "Phong highlight, now Blinn's");
    check(wanted.specular == got.specular, "highlight of another weight than the reflected ray");
    if (wanted.transmission == black) return;
    check(wanted.fresnel && wanted.transmission == white && wanted.reflection == got.reflection,
          "constant weights of reflected and refracted rays, now Fresnel's");
    check(wanted.ior == got.ior, "index of refraction");
    check(wanted.absorption == got.absorption, "absorption");
}

}  // namespace

P3fStatement to_p3f(const Material& m, ConversionWarnings& lost) {
    const P3fStatement s = m.transmission == black ? P3fStatement{opaque(m), true} : glass(m);
    compare(m, to_material(s.numbers, s.absorbs), lost);
    return s;
}

}  // namespace etalon
