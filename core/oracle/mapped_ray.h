#pragma once

#include "core/oracle/definitions.h"

namespace etalon::definition {

/// A ray in the coordinates of an affine map, by Cramer's rule: origin and direction are multiplied
/// by `unit`, the determinant.
struct MappedRay {
    MappedRay(const Affine& map, const Ray& ray) {
        const TrackedVec x = map.x, y = map.y, z = map.z;
        const TrackedVec from = TrackedVec(ray.origin) - map.origin, towards = ray.direction;
        const TrackedVec yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
        origin = {dot(yz, from), dot(zx, from), dot(xy, from)};
        direction = {dot(yz, towards), dot(zx, towards), dot(xy, towards)};
        unit = dot(x, yz);
    }

    TrackedVec origin, direction;
    Tracked unit;
};

}  // namespace etalon::definition
