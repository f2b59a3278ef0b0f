#pragma once

#include "core/scene/texture.h"

namespace etalon {

/// Returns the value of a texture at a point in the world, as pbrt-v3 defines it.
float procedural_value(const FbmTexture& texture, const Vec3& position);
float procedural_value(const WrinkledTexture& texture, const Vec3& position);
float procedural_value(const WindyTexture& texture, const Vec3& position);
Color procedural_value(const MarbleTexture& texture, const Vec3& position);

/// Returns whether texture coordinates are within one of pbrt-v3's dots. About every second cell,
/// of integers +- 0.5, has one of radius 0.35, displaced by the cell's noise.
bool is_in_dot(const Vec2& st);

}  // namespace etalon
