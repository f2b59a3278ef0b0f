// Materials by physical rules, as PBRT's scenes name them. Plain data; core/material turns one into
// the scattering of a point.
#pragma once

#include <memory>
#include <variant>

#include "core/scene/fourier_table.h"
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

/// Burley's material (2012, 2015). `thin`: a sheet without inside, which lets diffuse light
/// through.
struct DisneyMaterial {
    ColorSlot color;
    NumberSlot metallic, eta, roughness, specular_tint, anisotropic, sheen, sheen_tint, clearcoat,
        clearcoat_gloss, specular_transmission, flatness, diffuse_transmission;
    bool thin = false;
    ColorSlot scatter_distance{Color(0)};  ///< that light goes below the surface; 0: none does
    float unit = 1;                        ///< of that distance, as a length of the world
};

/// A border below which light is scattered by a medium, until it comes out elsewhere.
struct SubsurfaceMaterial {
    GlassMaterial border;              ///< with the same index everywhere
    ColorSlot absorption, scattering;  ///< coefficients
    float g = 0;                       ///< mean cosine of scattering, between -1 and 1
    float factor = 1;                  ///< of the coefficients
};

/// The same by what is seen of it.
struct KdSubsurfaceMaterial {
    GlassMaterial border;  ///< with the same index everywhere
    ColorSlot albedo;      ///< part of what entered that comes out
    ColorSlot free_path;   ///< mean one
    float g = 0;           ///< mean cosine of scattering, between -1 and 1
    float unit = 1;        ///< of the free path, as a length of the world
};

/// Scattering by a table.
struct FourierMaterial {
    std::shared_ptr<const FourierTable> table;  ///< null: nothing is scattered
};

/// What a hair's colour is told by.
enum class HairPigment : std::uint8_t { absorption, reflectance, melanin };

/// A fibre (Chiang et al. 2016), across which the surface's v goes.
struct HairMaterial {
    HairPigment pigment = HairPigment::melanin;
    ColorSlot color{Color(0)};  ///< absorption per radius, or reflectance
    NumberSlot eumelanin, pheomelanin;
    NumberSlot eta, beta_m, beta_n;  ///< roughness along and across the fibre
    NumberSlot alpha;                ///< tilt of its scales in degrees
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
                 UberMaterial, TranslucentMaterial, SubstrateMaterial, DisneyMaterial, HairMaterial,
                 SubsurfaceMaterial, KdSubsurfaceMaterial, FourierMaterial, MixedMaterial,
                 NoMaterial>
        kind;
    NumberSlot bump{};  ///< height of the surface above itself; of no effect without a texture
};

}  // namespace etalon
