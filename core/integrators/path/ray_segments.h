#pragma once

#include "core/intersect/ray.h"
#include "core/medium/ray_segment.h"

namespace etalon {

/// The part of a ray up to `end`.
inline RaySegment segment_of(const Ray& ray, double end) {
    const double length = ray.direction.length(), begin = std::max(ray.tmin, 0.0);
    return {ray.origin + begin * ray.direction, ray.direction / length, (end - begin) * length};
}

/// Returns the end of a ray.
inline double end_of(const Hit& hit) {
    return hit.primitive == no_index ? infinity : hit.t;
}

}  // namespace etalon
