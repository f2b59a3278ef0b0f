#pragma once

#include "core/scene/render_settings.h"
#include "core/scene/scene.h"

namespace etalon {

/// Samples per pixel of a scene whose format asks for one deterministic ray.
inline constexpr int physical_samples = 64;

/// The least that the maximum path length becomes: light that passes two glass balls, one in the
/// other, and comes from a diffuse surface takes a dozen rays.
inline constexpr int physical_depth = 16;

/// Gives a scene of a Whitted-style look a physical one, so that light can be followed through it
/// (docs/physical.md says how), and settings under which its image is in light. Primitives keep
/// their numbers; lights that have an extent become primitives after them. Does nothing to a scene
/// of a physical look.
void make_physical(Scene& scene, RenderSettings& settings);

}  // namespace etalon
