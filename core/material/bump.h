#pragma once

#include "core/material/material.h"

namespace etalon {

/// Shading normal and tangent of a point of a surface.
struct ShadingFrame {
    Vec3 ns, tangent;
};

/// The frame at a point of the surface that lies as far above the given one along its shading
/// normal as the texture `bump` says: Blinn 1978, "Simulation of Wrinkled Surfaces". The given
/// frame where that of the raised surface is degenerate.
ShadingFrame bumped(const NumberSlot& bump, const TextureValues& textures,
                    const MaterialPoint& point);

}  // namespace etalon
