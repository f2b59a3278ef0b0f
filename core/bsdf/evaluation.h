#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Scattering for two directions: the BSDF's value (without a cosine; per steradian), and the
/// density, per solid angle, with which sampling for the one yields the other.
struct Evaluation {
    Color f{0};
    float pdf = 0;
};

}  // namespace etalon
