#pragma once

#include "core/numerics/vec.h"
#include "core/scene/texture.h"

namespace etalon {

/// Ratio of the frequencies of two octaves; not 2, as their zeros must not coincide.
inline constexpr double lacunarity = 1.99;

/// Octaves of the waves of windy textures.
inline constexpr int windy_octaves = 6;

/// Returns a sum of octaves of gradient noise: the values of pbrt-v3 for a footprint so small that
/// all octaves count.
double fractional_brownian_motion(const FractalNoise& noise, const Vec3& p);

/// Returns the same sum of absolute values. As in pbrt-v3 one more octave is added with its mean,
/// which is taken to be 0.2.
double turbulence(const FractalNoise& noise, const Vec3& p);

}  // namespace etalon
