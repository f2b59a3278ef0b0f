#pragma once

#include <array>

#include "core/numerics/vec.h"
#include "core/scene/texture.h"

namespace etalon {

/// The texels around a point, and their weights.
struct NearTexels {
    std::array<std::size_t, 4> texels;  ///< numbers in rows from the top
    std::array<float, 4> weights;       ///< 0 for those beyond a black border
};

/// Returns the four texels of an image whose centres surround the point (s, t).
NearTexels near_texels(int width, int height, Wrap wrap, const Vec2& st);

}  // namespace etalon
