#pragma once

#include "core/scene/texture.h"

namespace etalon {

/// Returns the value of a texture at a point in the world, as pbrt-v3 defines it.
float procedural_value(const FbmTexture& texture, const Vec3& position);
float procedural_value(const WrinkledTexture& texture, const Vec3& position);
float procedural_value(const WindyTexture& texture, const Vec3& position);
Color procedural_value(const MarbleTexture& texture, const Vec3& position);

/// Tells whether texture coordinates are within one of pbrt-v3's dots: about every second cell, of
/// whole numbers +- 0.5, has one of radius 0.35, which the cell's noise moves.
bool is_in_dot(const Vec2& st);

}  // namespace etalon
