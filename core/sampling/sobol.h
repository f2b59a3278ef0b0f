// Points that depend on nothing but their number and a seed. No state, so any order, tiling or
// machine gives the same one.
#pragma once

#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon {

/// A 32-bit mix of two words; the basis of all names of dimensions.
std::uint32_t hash(std::uint32_t a, std::uint32_t b);

/// Point `index` of the two-dimensional Sobol' sequence, Owen-scrambled, its order shuffled by a
/// scramble of the index (Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4)). Every
/// seed gives an independent randomisation; in [0, 1)^2.
Vec2 scrambled_sobol(std::uint32_t index, std::uint32_t seed);

/// Point `index` of a sequence of independent, evenly distributed points in [0, 1)^2.
Vec2 uniform_random(std::uint32_t index, std::uint32_t seed);

}  // namespace etalon
