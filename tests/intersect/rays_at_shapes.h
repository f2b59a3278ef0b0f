// Rays that find what is wrong: aimed at corners, edges, rims and silhouettes, from everywhere.
// Random rays find nothing.
#pragma once

#include "core/intersect/ray.h"
#include "tests/intersect/shape_cases.h"

namespace etalon {

struct AimedRay {
    Ray ray;
    const char* ray_generator;
    const std::string* target;
};

/// `index` picks the target and the approach in turn, so that any run of consecutive numbers holds
/// all of them.
AimedRay aimed_ray(const ShapeCase& shape, int index, Random& random);

}  // namespace etalon
