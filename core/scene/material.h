// Material of a surface in the Whitted-style formats. One struct serves all formats: their loaders
// express the rules of each format as these numbers.
#pragma once

#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon {

/// Cosine that a highlight is a power of: that between N and the half vector of eye and light
/// (Blinn 1977), or that between the reflected camera ray and the light (Phong 1975).
enum class Highlight : std::uint8_t { blinn, phong };

struct Material {
    Color ambient{0.0F};   ///< independent of lights
    Color diffuse{0.0F};   ///< times max(0, N.L), for each light
    Color specular{0.0F};  ///< times max(0, cosine)^shininess, for each light
    double shininess = 1;
    Highlight highlight = Highlight::blinn;

    Color reflection{0.0F};    ///< weight of the reflected ray
    Color transmission{0.0F};  ///< weight of the refracted ray
    bool fresnel = false;      ///< the two weights are also multiplied by F and 1 - F
    double ior = 1;            ///< refractive index behind the surface; 1 in front of it
    Color absorption{0.0F};    ///< per unit of length behind the surface (Beer-Lambert)
};

}  // namespace etalon
