// Rays at a target from everywhere: from afar, from close by, from within, along axes.
#pragma once

#include "core/intersect/ray.h"
#include "core/test_rays/targets.h"

namespace etalon::hard {

/// Approximate position and size of a shape.
struct Place {
    Vec3 centre;
    double size;
};

/// Ray by one of the ray generators, chosen at random. Hardly any of the rays start on a surface.
Ray ray_generator(const Place& place, const Target& target, Random& random);

/// Ray from the target itself, on or next to the surface, in any direction.
Ray leave(const Place& place, const Target& target, Random& random);

/// Ray along an edge, a generator, a face.
Ray through_two(const Place& place, const Target& target, Random& random);

}  // namespace etalon::hard
