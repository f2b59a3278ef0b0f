#pragma once

#include <variant>

#include "core/numerics/vec.h"

namespace etalon {

/// A point that shines alike in all directions and over all distances.
struct PointLight {
    Vec3 position;
    Color color;
};

/// A parallelogram of point lights: no cosine, no area and no distance factor.
struct QuadLight {
    Vec3 corner, edge1, edge2;
    Color color;  ///< shared among the samples taken
    int samples;  ///< > 0; how many a deterministic (spp 0) image takes
};

using Light = std::variant<PointLight, QuadLight>;

}  // namespace etalon
