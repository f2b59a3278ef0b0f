// Physical materials, as PBRT's scenes name them. Plain data; core/material turns one into the BSDF
// of a point.
#pragma once

#include <memory>
#include <variant>

#include "core/scene/fourier_table.h"
#include "core/scene/texture.h"

namespace etalon {

/// Lambertian reflection, or Oren and Nayar's (1994) if `sigma`, in degrees, is above 0.
struct MatteMaterial {
    ColorSlot kd;
    NumberSlot sigma;
};

/// Roughness of a microfacet surface along u and v. With `remap` the numbers are perceptually even
/// from 0 to 1, not Trowbridge and Reitz's alpha.
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

/// A dielectric interface; smooth if both roughnesses are 0.
struct GlassMaterial {
    ColorSlot kr, kt;
    NumberSlot eta;
    Roughness roughness;
};

struct MetalMaterial {
    ColorSlot eta, k;
    Roughness roughness;
};

/// Diffuse, glossy, mirrored and transmitted light, each with a colour of its own.
struct UberMaterial {
    ColorSlot kd, ks, kr, kt, opacity;
    NumberSlot eta;
    Roughness roughness;
};

/// Diffuse and glossy scattering to both sides.
struct TranslucentMaterial {
    ColorSlot kd, ks, reflect, transmit;
    Roughness roughness;
};

/// A diffuse base under a glossy coat (Ashikhmin and Shirley 2000).
struct SubstrateMaterial {
    ColorSlot kd, ks;
    Roughness roughness;
};

/// Burley's material (2012, 2015). `thin` is a sheet without volume that transmits diffuse light.
struct DisneyMaterial {
    ColorSlot color;
    NumberSlot metallic, eta, roughness, specular_tint, anisotropic, sheen, sheen_tint, clearcoat,
        clearcoat_gloss, specular_transmission, flatness, diffuse_transmission;
    bool thin = false;
    ColorSlot scatter_distance{Color(0)};  ///< mean distance below the surface; 0 for none
    float unit = 1;                        ///< length of its unit in the world
};

/// A surface below which a medium scatters light until it leaves at another point.
struct SubsurfaceMaterial {
    GlassMaterial boundary;            ///< its index is constant
    ColorSlot absorption, scattering;  ///< coefficients
    float g = 0;                       ///< mean cosine of scattering, between -1 and 1
    float factor = 1;                  ///< factor of the coefficients
};

/// Subsurface scattering given by what is observed of it.
struct KdSubsurfaceMaterial {
    GlassMaterial boundary;  ///< its index is constant
    ColorSlot albedo;        ///< fraction of the light that entered which leaves
    ColorSlot free_path;     ///< mean free path
    float g = 0;             ///< mean cosine of scattering, between -1 and 1
    float unit = 1;          ///< length of the free path's unit in the world
};

/// Scattering by a table.
struct FourierMaterial {
    std::shared_ptr<const FourierTable> table;  ///< null if nothing is scattered
};

/// Quantity that determines a hair's colour.
enum class HairPigment : std::uint8_t { absorption, reflectance, melanin };

/// A fibre (Chiang et al. 2016). The surface's v runs across it.
struct HairMaterial {
    HairPigment pigment = HairPigment::melanin;
    ColorSlot color{Color(0)};  ///< absorption per radius, or reflectance
    NumberSlot eumelanin, pheomelanin;
    NumberSlot eta, beta_m, beta_n;  ///< roughness along and across the fibre
    NumberSlot alpha;                ///< tilt of its scales in degrees
};

/// A mixture: `amount` of the first material and the rest of the second. Numbers are those among
/// the look's materials.
struct MixedMaterial {
    std::uint32_t first, second;
    ColorSlot amount;
};

/// No surface: rays pass through.
struct NoMaterial {};

struct PhysicalMaterial {
    std::variant<MatteMaterial, PlasticMaterial, MirrorMaterial, GlassMaterial, MetalMaterial,
                 UberMaterial, TranslucentMaterial, SubstrateMaterial, DisneyMaterial, HairMaterial,
                 SubsurfaceMaterial, KdSubsurfaceMaterial, FourierMaterial, MixedMaterial,
                 NoMaterial>
        kind;
    NumberSlot bump{};  ///< height of the displaced surface; no effect unless it is a texture
};

}  // namespace etalon
