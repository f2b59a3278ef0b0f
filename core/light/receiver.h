#pragma once

#include <cstdint>

#include "core/numerics/vec.h"

namespace etalon {

/// A point that lights illuminate.
struct Receiver {
    Vec3 position;
    Vec3 normal{0.0};  ///< unit, on the side that reflects; 0 if both sides scatter light
    /// Set by Lights::pick for pick_probability: importance of all lights if all are compared, else
    /// of those at infinity; and the probability of the lights of the tree.
    double total_importance = 0;
    double tree_probability = 0;
};

struct LightPick {
    std::uint32_t light;
    double probability;
};

}  // namespace etalon
