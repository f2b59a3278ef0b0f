#pragma once

#include "core/scene/render_settings.h"
#include "core/scene/scene.h"

namespace etalon {

/// Samples per pixel if the scene's format specifies one deterministic ray.
inline constexpr int physical_samples = 64;

/// Least maximum path length. Light that passes two nested glass balls and comes from a diffuse
/// surface takes a dozen rays.
inline constexpr int physical_depth = 16;

/// Converts a scene with a Whitted-style look to a physical one, for path tracing (see
/// docs/physical.md), and its settings so that the image is in light. Primitives keep their
/// numbers; lights with an extent become primitives after them. Does nothing to a scene with a
/// physical look.
void make_physical(Scene& scene, RenderSettings& settings);

}  // namespace etalon
