// The measured index of refraction of copper, to compare the default metal of PBRT with.
#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Returns the real part n of the index of refraction n + ik.
Color copper_eta();

/// Returns the imaginary part k, the extinction coefficient.
Color copper_k();

}  // namespace etalon
