#include "tests/fuzz/rays/palette.h"

#include <array>

namespace etalon::fuzz {
namespace {

/// Least largest component of a normal; the other components may be denormal.
constexpr double least_normal = 1e-150;

constexpr std::array far_steps = {1.0, 0x1p-20, 1e-6, 0.1, 1e3};

/// Moves a number by up to two units in its last place.
double neighbour(double x, Random& random) {
    const double towards = random.sign() * infinity;
    for (std::uint32_t i = random.index(3); i > 0; --i) x = std::nextafter(x, towards);
    return std::abs(x) < 0x1p-1000 ? 0 : x;
}

}  // namespace

AdversarialNumbers::AdversarialNumbers(Palette palette, Random& random)
    : palette_(palette),
      random_(random),
      offset_(random.magnitude(0, 12) * random.in_cube()),
      step_(far_steps[random.index(far_steps.size())]) {}

double AdversarialNumbers::number(Palette palette) const {
    switch (palette) {
        case Palette::whole:
            return whole();
        case Palette::powers:
            return random_.one_in(5)
                       ? 0
                       : std::ldexp(random_.sign(), static_cast<int>(random_.index(41)) - 20);
        case Palette::beside:
            return neighbour(whole(), random_);
        case Palette::far:
            return offset_.x + step_ * whole();
        case Palette::decimal:
            return (random_.index(2001) - 1000.0) / 100;
        case Palette::wild:
            break;
    }
    if (random_.one_in(8)) return random_.sign() * 1e20;
    if (random_.one_in(8)) return random_.sign() * 1e-20;
    return number(static_cast<Palette>(random_.index(palettes - 1)));
}

Vec3 AdversarialNumbers::point() const {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
}

Vec3 AdversarialNumbers::point_beside(const Vec3& other) const {
    Vec3 p = point();
    const std::uint32_t kept = random_.index(8);
    for (int k = 0; k < 3; ++k) {
        if ((kept >> k & 1) != 0) p[k] = other[k];
    }
    return p;
}

double AdversarialNumbers::length() const {
    const double x = palette_ == Palette::far ? step_ * whole() : coordinate();
    return x == 0 ? 1 : std::abs(x);
}

Vec3 AdversarialNumbers::direction() const {
    Vec3 d(whole(), whole(), whole());
    if (random_.one_in(3)) d[random_.axis()] = neighbour(d[random_.axis()], random_);
    if (random_.one_in(4)) d = random_.direction();
    if (random_.one_in(12)) d[random_.axis()] = random_.sign() * 1e-20;
    return max_abs(d) < least_normal ? Vec3(0, 0, 1) : d;
}

}  // namespace etalon::fuzz
