// Rays at a target from everywhere: from far away, nearby or inside, and along axes.
#pragma once

#include "core/intersect/ray.h"
#include "core/test_rays/targets.h"

namespace etalon::hard {

/// Approximate centre and size of a shape or scene.
struct Extent {
    Vec3 centre;
    double size;
};

/// Returns a ray of one of the generators, chosen at random. Hardly any of the rays start on a
/// surface.
Ray ray_generator(const Extent& extent, const Target& target, Random& random);

/// Returns a ray from the target itself, on or next to the surface, in any direction.
Ray leave(const Extent& extent, const Target& target, Random& random);

/// Returns a ray along an edge, a generator or a face.
Ray through_two(const Extent& extent, const Target& target, Random& random);

}  // namespace etalon::hard
