#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Returns the luminance of a colour with the primaries of Rec. 709, by pbrt-v3's weights.
inline float luminance(const Color& c) {
    return 0.212671F * c.x + 0.715160F * c.y + 0.072169F * c.z;
}

}  // namespace etalon
