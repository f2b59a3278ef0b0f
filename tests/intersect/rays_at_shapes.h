// Rays aimed at corners, edges, rims and silhouettes, from everywhere. Random rays do not find
// errors.
#pragma once

#include "core/intersect/ray.h"
#include "tests/intersect/shape_cases.h"

namespace etalon {

struct AimedRay {
    Ray ray;
    const char* ray_generator;
    const std::string* target;
};

/// Returns a ray. `index` selects the target and the ray generator in turn, so that any run of
/// consecutive numbers has all of them.
AimedRay aimed_ray(const ShapeCase& shape, int index, Random& random);

}  // namespace etalon
