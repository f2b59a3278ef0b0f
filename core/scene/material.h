// What a surface does with light, as the Whitted-style formats say it. One table serves them all:
// a format's own rules are turned into these numbers by its loader.
#pragma once

#include "core/numerics/vec.h"

namespace etalon {

struct Material {
    Color diffuse{0.0F};   ///< times max(0, N.L), for each light
    Color specular{0.0F};  ///< times max(0, N.H)^shininess, for each light (Blinn 1977)
    double shininess = 1;

    Color reflection{0.0F};    ///< weight of the mirrored ray
    Color transmission{0.0F};  ///< weight of the refracted ray
    bool fresnel = false;      ///< the two weights are further multiplied by F and 1 - F
    double ior = 1;            ///< refractive index behind the surface; 1 in front of it
    Color absorption{0.0F};    ///< per unit of length behind the surface (Beer-Lambert)
};

}  // namespace etalon
