// Numbers of which scenes and rays are made where kernels and boxes are likeliest to be wrong.
#pragma once

#include "core/numerics/random.h"

namespace etalon::fuzz {

/// The numbers of one scene. All scenes of all numbers would mostly be dust beside giants.
enum class Palette {
    whole,    ///< small whole numbers: ties, shared corners, rays along edges; sums are exact
    powers,   ///< 0 and powers of two of either sign
    beside,   ///< whole numbers and their neighbours among doubles
    far,      ///< near one another, far from the origin
    decimal,  ///< few digits, as in files
    wild,     ///< all of these, and 1e-20 and 1e20
};
inline constexpr std::size_t palettes = 6;

/// A source of the numbers of a scene.
class NastyNumbers {
  public:
    NastyNumbers(Palette palette, Random& random);

    Palette palette() const { return palette_; }
    Random& random() const { return random_; }

    double coordinate() const { return number(palette_); }
    Vec3 point() const;

    /// A point of which some coordinates are those of `other`.
    Vec3 point_beside(const Vec3& other) const;

    /// A length above 0.
    double length() const;

    /// A direction with zeros and numbers that are equal or nearly so; of any length but 0.
    Vec3 direction() const;

  private:
    double number(Palette palette) const;
    double whole() const { return random_.index(9) - 4.0; }

    Palette palette_;
    Random& random_;
    Vec3 offset_;
    double step_;
};

}  // namespace etalon::fuzz
