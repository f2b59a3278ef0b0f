#pragma once

#include <optional>

#include "core/light/equiangular.h"
#include "core/scene/physical_light.h"

namespace etalon {

/// Returns the interval of a ray on which a light without extent shines. Nothing if the light has
/// no position, or does not shine on the ray before `length`.
std::optional<Equiangular> lit_range(const PhysicalLight& light, const Vec3& origin,
                                     const Vec3& direction, double length);

}  // namespace etalon
