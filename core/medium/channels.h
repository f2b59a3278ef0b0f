#pragma once

#include "core/numerics/vec.h"

namespace etalon {

/// Returns the channel that `choice` in [0, 1) selects by probabilities whose sum is 1.
inline int chosen_channel(const Color& probabilities, double choice) {
    if (choice < probabilities.x) return 0;
    return choice < probabilities.x + probabilities.y || probabilities.z == 0 ? 1 : 2;
}

}  // namespace etalon
