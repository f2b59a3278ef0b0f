#pragma once

#include <cmath>

#include "core/numerics/luminance.h"

namespace etalon {

/// Returns how much light of a colour matters, whatever the signs of its components: some scenes
/// have lights that take light away. For others it is the luminance; it is 0 for black only.
inline float strength(const Color& c) {
    return luminance({std::abs(c.x), std::abs(c.y), std::abs(c.z)});
}

}  // namespace etalon
