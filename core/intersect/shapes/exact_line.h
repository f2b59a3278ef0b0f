#pragma once

#include "core/intersect/ray.h"
#include "core/numerics/dyadic_vec.h"

namespace etalon {

/// A line in local coordinates, multiplied by the map's determinant, which is made positive. The
/// adjugate takes the place of the inverse, so that no division is needed.
struct ExactLine {
    ExactLine(const Affine& map, const Ray& ray);

    DyadicVec w, d;
    Dyadic unit;  ///< the determinant
};

}  // namespace etalon
