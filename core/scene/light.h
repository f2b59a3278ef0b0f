#pragma once

#include <variant>

#include "core/numerics/vec.h"

namespace etalon {

/// A point light of the same strength in all directions and at all distances.
struct PointLight {
    Vec3 position;
    Color color;
};

/// A parallelogram of point lights, without factors for cosine, area or distance.
struct QuadLight {
    Vec3 corner, edge1, edge2;
    Color color;  ///< divided among the samples taken
    int samples;  ///< number of samples in a deterministic (spp 0) image; > 0
};

using Light = std::variant<PointLight, QuadLight>;

}  // namespace etalon
