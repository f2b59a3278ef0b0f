// Scenes of many shapes, and rays in them.
#pragma once

#include "bench/hard_cases/ray_generators.h"
#include "bench/hard_cases/rows.h"

namespace etalon::hard {

/// Parameters of a random scene: number, kinds and sizes of its primitives, and the seed.
struct RandomSceneConfig {
    std::size_t count = 1000;
    std::uint64_t seed = 1;
    std::vector<ShapeKind> kinds = {};       ///< empty: all, planes rarely
    double smallest = 0.15, largest = 0.15;  ///< sizes, uniform in the exponent
    bool one_sided = false;                  ///< a third shows only its front, a third its back
};

/// Returns shapes whose centres are in the cube [-1, 1]^3.
Scene random_scene(const RandomSceneConfig& config);

/// Returns rays from everywhere at the targets on the scene's primitives, see targets_of(); a third
/// of the rays starts or ends somewhere in between. With offsets down to 1e-6, double decides
/// between hit and miss even at 1e7 sizes.
CaseSetup aimed_at_scene(Scene scene, double finest = -6);

/// Returns rays from next to a point of one primitive, by 1e-6 to 1e-1 of its size, to anywhere.
CaseSetup bouncing_in_scene(Scene scene);

/// Returns camera rays from `distance` times the scene's size, through all of a screen.
CaseSetup camera_rays_of(Scene scene, double distance);

}  // namespace etalon::hard
