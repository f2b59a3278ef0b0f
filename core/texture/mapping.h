#pragma once

#include "core/scene/texture.h"
#include "core/texture/texture_point.h"

namespace etalon {

/// Returns the coordinates (s, t) that a texture has at a point. At the origin of a spherical or
/// cylindrical mapping they are those of its z axis.
Vec2 texture_coordinates(const Mapping& mapping, const TexturePoint& point);

}  // namespace etalon
