#pragma once

#include <cstdint>

#include "core/scene/material.h"
#include "core/shading/shadow_rays.h"

namespace etalon {

/// Returns max(0, cosine)^shininess of a material's highlight for a ray of unit length, a unit
/// shading normal on the light's side and a unit vector to the light: see Material.
double highlight(const Material& material, const Vec3& direction, const Vec3& normal,
                 const Vec3& towards);

/// Sets values[i] to the highlight of each shadow ray in [first, last) that is not blocked, rounded
/// to float, and that of others to anything. These rays leave surfaces of one material. The bits
/// are those of highlight(); several are computed at a time. `values` is padded.
void find_highlights(const Material& material, const SeenSurfaces& surfaces,
                     const ShadowRays& shadow, std::size_t first, std::size_t last,
                     PaddedColumn<float>& values);

}  // namespace etalon
