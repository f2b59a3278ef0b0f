// Scenes of many shapes, and rays at them.
#pragma once

#include "bench/hard_cases/approaches.h"
#include "bench/hard_cases/rows.h"

namespace etalon::hard {

/// What a scene's primitives are chosen from.
struct WorldPlan {
    std::size_t count = 1000;
    std::uint64_t seed = 1;
    std::vector<ShapeKind> kinds = {};       ///< empty: all of them, planes rarely
    double smallest = 0.15, largest = 0.15;  ///< sizes, evenly in the exponent
    bool one_sided = false;                  ///< a third shows its front only, a third its back
};

/// Shapes whose middles are in the cube [-1, 1]^3.
Scene world(const WorldPlan& plan);

/// Every length times `factor`, then every point moved by `offset`.
Scene moved(Scene scene, double factor, const Vec3& offset);

/// From everywhere to what there is to aim at on the scene's primitives; a third of the rays starts
/// or ends somewhere along the way.
Setting aimed_at_world(Scene scene);

/// From a point of one primitive to anywhere.
Setting bouncing_in_world(Scene scene);

/// From an eye at `distance` times the scene's size, through all of a screen.
Setting seen_from_eye(Scene scene, double distance);

}  // namespace etalon::hard
