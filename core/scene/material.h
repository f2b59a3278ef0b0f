// Material of a surface, as the Whitted-style formats say it. One table serves them all:
// a format's own rules are turned into these numbers by its loader.
#pragma once

#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon {

/// Angle whose cosine a highlight is a power of: between N and the half of eye and light (Blinn
/// 1977), or between the mirrored camera ray and the light (Phong 1975).
enum class Highlight : std::uint8_t { blinn, phong };

struct Material {
    Color ambient{0.0F};   ///< sent back whatever the light
    Color diffuse{0.0F};   ///< times max(0, N.L), for each light
    Color specular{0.0F};  ///< times max(0, cosine)^shininess, for each light
    double shininess = 1;
    Highlight highlight = Highlight::blinn;

    Color reflection{0.0F};    ///< weight of the mirrored ray
    Color transmission{0.0F};  ///< weight of the refracted ray
    bool fresnel = false;      ///< the two weights are further multiplied by F and 1 - F
    double ior = 1;            ///< refractive index behind the surface; 1 in front of it
    Color absorption{0.0F};    ///< per unit of length behind the surface (Beer-Lambert)
};

}  // namespace etalon
