#pragma once

#include "core/material/material.h"

namespace etalon {

/// Shading normal and tangent of a point of a surface.
struct ShadingFrame {
    Vec3 ns, tangent;
};

/// Returns the frame of the surface that is displaced along the shading normal by the texture
/// `bump`: Blinn 1978, "Simulation of Wrinkled Surfaces". Returns the given frame if that of the
/// displaced surface is degenerate.
ShadingFrame bumped(const NumberSlot& bump, const TextureValues& textures,
                    const MaterialPoint& point);

}  // namespace etalon
