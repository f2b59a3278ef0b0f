// Rays at a target from everywhere: from afar, from within, from the target itself, along axes.
#pragma once

#include "bench/hard_cases/targets.h"
#include "core/intersect/ray.h"

namespace etalon::hard {

/// Where a shape is, roughly.
struct Place {
    Vec3 centre;
    double size;
};

/// By one of the approaches, at random.
Ray approach(const Place& place, const Target& target, Random& random);

}  // namespace etalon::hard
