// Coordinates for scenes and rays with which kernels and bounds are most likely to be wrong.
#pragma once

#include "core/numerics/random.h"

namespace etalon::fuzz {

/// The kind of numbers in one scene. If all kinds were mixed, most scenes would have tiny shapes
/// beside huge ones.
enum class Palette {
    whole,    ///< small whole numbers: ties, shared corners, rays along edges; sums are exact
    powers,   ///< 0 and powers of two of either sign
    beside,   ///< whole numbers and their neighbours among doubles
    far,      ///< close together, far from the origin
    decimal,  ///< few digits, as in files
    wild,     ///< all of these, and 1e-20 and 1e20
};
inline constexpr std::size_t palettes = 6;

/// Generates the random numbers of one scene.
class AdversarialNumbers {
  public:
    AdversarialNumbers(Palette palette, Random& random);

    Palette palette() const { return palette_; }
    Random& random() const { return random_; }

    double coordinate() const { return number(palette_); }
    Vec3 point() const;

    /// Returns a point that shares some coordinates with `other`.
    Vec3 point_beside(const Vec3& other) const;

    /// Returns a length above 0.
    double length() const;

    /// Returns a direction, not normalised, whose components are often 0, equal or nearly equal. It
    /// is never 0.
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
