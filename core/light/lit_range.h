#pragma once

#include <optional>

#include "core/light/equiangular.h"
#include "core/scene/physical_light.h"

namespace etalon {

/// The points of a ray that a light without extent shines on, if it has a place: none where it has
/// not, or does not shine on the ray before `length`.
std::optional<Equiangular> lit_range(const PhysicalLight& light, const Vec3& origin,
                                     const Vec3& direction, double length);

}  // namespace etalon
