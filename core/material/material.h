#pragma once

#include <vector>

#include "core/bsdf/bsdf.h"
#include "core/scene/physical_material.h"
#include "core/texture/texture_values.h"

namespace etalon {

/// Data of a surface point that a material needs. Normals are unit vectors, not turned to the eye.
/// The derivatives are those of the shading geometry.
struct MaterialPoint {
    Vec3 ng, ns;
    Vec3 dpdu, dpdv;
    Vec2 uv;
    Vec3 position;
    Vec3 dndu{0}, dndv{0};  ///< derivatives of the shading normal
};

/// Returns the frame in which a material scatters at a point, rotated by its bump map.
BsdfFrame bsdf_frame(const PhysicalMaterial& material, const std::vector<PhysicalMaterial>& all,
                     const TextureValues& textures, const MaterialPoint& point);

/// Returns whether that frame depends on the point's coordinates.
bool is_bumpy(const PhysicalMaterial& material, const std::vector<PhysicalMaterial>& all);

/// Returns the lobes at a point of a surface of `material`, one of `all`, as PBRT version 3 defines
/// its materials. NoMaterial has none.
LobeList lobes_at(const PhysicalMaterial& material, const std::vector<PhysicalMaterial>& all,
                  const TextureValues& textures, const TexturePoint& point);

/// Returns the lobes of a material that are the same at all points: of one without textures and
/// coordinates. Nothing for others.
std::optional<LobeList> constant_lobes(const PhysicalMaterial& material,
                                       const std::vector<PhysicalMaterial>& all,
                                       const TextureValues& textures);

/// Returns frame and lobes.
Bsdf scattering(const PhysicalMaterial& material, const std::vector<PhysicalMaterial>& all,
                const TextureValues& textures, const MaterialPoint& point);

}  // namespace etalon
