// The measured index of refraction of copper: what a metal is made of that does not say what.
#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Real part n of the index of refraction n + ik.
Color copper_eta();

/// Imaginary part k, the extinction coefficient.
Color copper_k();

}  // namespace etalon
