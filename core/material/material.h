#pragma once

#include <vector>

#include "core/bsdf/bsdf.h"
#include "core/scene/physical_material.h"
#include "core/texture/texture_values.h"

namespace etalon {

/// What a material must know of a point of a surface. Normals are unit vectors, not turned to the
/// eye. The derivatives are those of the shading geometry.
struct MaterialPoint {
    Vec3 ng, ns;
    Vec3 dpdu, dpdv;
    Vec2 uv;
    Vec3 position;
    Vec3 dndu{0}, dndv{0};  ///< of the shading normal
};

/// Scattering of a point of a surface of `material`, one of `all`, as PBRT version 3 defines its
/// materials. NoMaterial has no lobes.
Bsdf scattering(const PhysicalMaterial& material, const std::vector<PhysicalMaterial>& all,
                const TextureValues& textures, const MaterialPoint& point);

}  // namespace etalon
