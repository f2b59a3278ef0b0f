#pragma once

#include "core/scene/material.h"

namespace etalon {

/// The eleven numbers of a `mat` (or `f`) statement.
struct P3fMaterial {
    Color diffuse{1.0F};
    double kd = 1;
    Color specular{1.0F};
    double ks = 0;  ///< also the weight of the reflected ray
    double shine = 1;
    double transmission = 0;  ///< 1 for glass
    double ior = 1;
};

/// Converts the numbers to a material. Glass of a `mat` absorbs the complement of its diffuse
/// colour; that of an `f` absorbs nothing.
Material to_material(const P3fMaterial& numbers, bool absorbs);

}  // namespace etalon
