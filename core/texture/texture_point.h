#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Point of a surface as textures see it.
struct TexturePoint {
    Vec2 uv;        ///< the surface's coordinates
    Vec3 position;  ///< in the world
};

}  // namespace etalon
