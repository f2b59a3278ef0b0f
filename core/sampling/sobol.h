// Points that depend only on their number and a seed. There is no state, so that any order, tiling
// or machine gives the same ones.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon {

/// Mixes two words into 32 bits; the basis of all names of dimensions.
inline std::uint32_t hash(std::uint32_t a, std::uint32_t b) {
    // Finalizer of MurmurHash3 (Appleby) over both words; the multipliers are odd, so it is a
    // bijection of the 64 bits before they are folded.
    std::uint64_t h = (static_cast<std::uint64_t>(a) << 32 | b) + 0x9e3779b97f4a7c15ULL;
    h = (h ^ (h >> 33)) * 0xff51afd7ed558ccdULL;
    h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    return static_cast<std::uint32_t>(h ^ (h >> 33));
}

/// Number of points to which columns of their names are padded: eight or sixteen take little longer
/// than one.
inline constexpr std::size_t sobol_lanes = 16;

/// The two-dimensional Sobol' sequence, Owen-scrambled, with its order shuffled by a scramble of
/// the index (Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4)). Every seed gives an
/// independent randomisation.
class ScrambledSobol {
  public:
    explicit ScrambledSobol(std::uint32_t seed)
        : order_(hash(seed, 0)), x_(hash(seed, 1)), y_(hash(seed, 2)) {}

    /// Returns point number `index`, in [0, 1)^2.
    Vec2 operator()(std::uint32_t index) const;

  private:
    std::uint32_t order_, x_, y_;  ///< seeds of the three scrambles
};

/// Returns point `index` of a sequence of independent, uniformly distributed points in [0, 1)^2.
Vec2 uniform_random(std::uint32_t index, std::uint32_t seed);

}  // namespace etalon
