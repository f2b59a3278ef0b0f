#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// What scattering says of two directions: the BSDF's value (no cosine in it; per steradian), and
/// the density, by solid angle, with which sampling for the one yields the other.
struct Evaluation {
    Color f{0};
    float pdf = 0;
};

}  // namespace etalon
