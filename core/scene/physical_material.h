// Materials by physical rules, as PBRT's scenes name them. Plain data; core/material turns one into
// the scattering of a point.
#pragma once

#include <variant>

#include "core/scene/texture.h"

namespace etalon {

/// Lambert's reflection, or Oren and Nayar's (1994) where `sigma`, in degrees, is above 0.
struct MatteMaterial {
    ColorSlot kd;
    NumberSlot sigma;
};

/// Roughness of a microfacet surface along u and v. `remap`: the numbers are from 0 to 1 in even
/// steps of appearance, not Trowbridge and Reitz's alpha.
struct Roughness {
    NumberSlot u, v;
    bool remap = true;
};

/// A diffuse base under rough dielectric gloss of index 1.5.
struct PlasticMaterial {
    ColorSlot kd, ks;
    Roughness roughness;
};

struct MirrorMaterial {
    ColorSlot kr;
};

/// A boundary between dielectrics; smooth where both roughnesses are 0.
struct GlassMaterial {
    ColorSlot kr, kt;
    NumberSlot eta;
    Roughness roughness;
};

struct MetalMaterial {
    ColorSlot eta, k;
    Roughness roughness;
};

/// Diffuse, glossy, mirrored and transmitted light, each by a colour of its own.
struct UberMaterial {
    ColorSlot kd, ks, kr, kt, opacity;
    NumberSlot eta;
    Roughness roughness;
};

/// Diffuse and glossy light to both sides.
struct TranslucentMaterial {
    ColorSlot kd, ks, reflect, transmit;
    Roughness roughness;
};

/// A diffuse base under a glossy coat (Ashikhmin and Shirley 2000).
struct SubstrateMaterial {
    ColorSlot kd, ks;
    Roughness roughness;
};

/// `amount` of the first material and the rest of the second; numbers among the look's materials.
struct MixedMaterial {
    std::uint32_t first, second;
    ColorSlot amount;
};

/// No surface: a ray passes on.
struct NoMaterial {};

struct PhysicalMaterial {
    std::variant<MatteMaterial, PlasticMaterial, MirrorMaterial, GlassMaterial, MetalMaterial,
                 UberMaterial, TranslucentMaterial, SubstrateMaterial, MixedMaterial, NoMaterial>
        kind;
    NumberSlot bump{};  ///< height of the surface above itself; of no effect without a texture
};

}  // namespace etalon
